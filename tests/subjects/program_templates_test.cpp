#include "subjects/libraries/program_templates.hpp"

#include <boost/test/unit_test.hpp>
#include <cctype>
#include <set>

#include "geometry/case_line.hpp"
#include "subjects/libraries/libraries.hpp"
#include "subjects/libraries/template_texts.hpp"

using namespace rayaudit;

namespace {

std::string filled_with(const std::string& body, const std::string& line,
                        const Format& format = double_format,
                        std::string_view file = "ode.sphere.cpp") {
  return filled(read_template(file, body), read_case_line(line).question, format);
}

const std::string sphere = "sphere 1 0.5 -2 3 ray 0.1 0 -0 1e300 -1e-300 7";

/// A case of each shape that stands upright.
Case upright(std::string_view shape) {
  std::string numbers = "0 0 -2 0 0 2 1";
  if (shape == "sphere") numbers = "0 0 0 1";
  return read_case_line(std::string(shape) + ' ' + numbers + " ray 3 4 5 1 0 0.5").question;
}

}  // namespace

BOOST_AUTO_TEST_CASE(its_first_lines_say_how_it_is_built_and_what_the_documentation_says) {
  const ProgramTemplate read = read_template("ode.sphere.cpp",
                                             "// build: c++ FILE -o PROGRAM\n"
                                             "// says wrong_t: \"a: distance\" (manual)\n"
                                             "// says any: \"the first hit\" (header)\n"
                                             "// not one of those\n"
                                             "int main() {}\n");
  BOOST_TEST(read.build == "c++ FILE -o PROGRAM");
  BOOST_TEST(read.body == "// not one of those\nint main() {}\n");
  BOOST_TEST(read.ending() == ".cpp");
  BOOST_TEST(says_of(read, "wrong_t").value() == "\"a: distance\" (manual)");
  BOOST_TEST(says_of(read, "false_miss").value() == "\"the first hit\" (header)");
  BOOST_TEST(!says_of(read_template("a.sphere.cpp", "// says behind: x\n"), "false_hit"));
}

BOOST_AUTO_TEST_CASE(numbers_are_literals_that_read_back_exactly) {
  BOOST_TEST(filled_with("@ox@ @oy@ @dx@ @dy@ @dz@ @cx@ @cz@ @r@", sphere) ==
             "0.1 0.0 1e+300 -1e-300 7.0 1.0 -2.0 3.0");
  BOOST_TEST(filled_with("@ox@ @cy@ @dz@", sphere, float_format) == "0.1 0.5f 7.0f");
  BOOST_TEST(filled_with("@r@", "sphere 0 0 0 0x1.99999ap-4 ray 0 0 0 0 0 1", float_format) ==
             "0.1f");
  BOOST_TEST(filled_with("@r@", "sphere 0 0 0 0x1.99999ap-4 ray 0 0 0 0 0 1", float_format,
                         "three.sphere.mjs") == "0.10000000149011612");
}

BOOST_AUTO_TEST_CASE(the_range_and_half_the_height_are_numbers_too) {
  const std::string ranged = "capped_cone 0 0 -2 0 0 2 1 ray 0 0 0 0 0 1 range 0.5 inf";
  BOOST_TEST(filled_with("@t_min@ @t_max@ 2 * @h@", ranged) == "0.5 INFINITY 2 * 2.0");
  BOOST_TEST(filled_with("@t_max@", ranged, double_format, "a.cone.mjs") == "Infinity");
  BOOST_TEST(filled_with("@az@ @bz@", ranged) == "-2.0 2.0");
}

BOOST_AUTO_TEST_CASE(the_type_of_a_number_is_a_place_too) {
  BOOST_TEST(filled_with("using Real = @real@;", sphere) == "using Real = double;");
  BOOST_TEST(filled_with("@real@ @r@", sphere, float_format) == "float 3.0f");
}

BOOST_AUTO_TEST_CASE(what_is_no_place_stays) {
  BOOST_TEST(filled_with("import '@babylonjs/core'; // @ a@b @ox@ @unknown@", sphere) ==
             "import '@babylonjs/core'; // @ a@b 0.1 @unknown@");
}

BOOST_AUTO_TEST_CASE(every_template_is_of_a_library_and_a_shape_and_leaves_no_place_open) {
  BOOST_TEST(!template_texts().empty());
  for (const auto& [file, text] : template_texts()) {
    BOOST_TEST_CONTEXT(file) {
      const ProgramTemplate read = read_template(file, text);
      BOOST_TEST(read.build.find("FILE") != read.build.npos);
      BOOST_TEST(!read.says.empty());
      const std::string name(file.substr(0, file.rfind('.')));
      const std::string shape = name.substr(name.rfind('.') + 1);
      BOOST_TEST_REQUIRE(
          std::set<std::string_view>(shape_names.begin(), shape_names.end()).contains(shape));
      BOOST_TEST(std::any_of(libraries().begin(), libraries().end(), [&](const Library& library) {
        return name.starts_with(library.stem());
      }));
      const std::string program = filled(read, upright(shape), double_format);
      for (std::size_t at = program.find('@'); at != program.npos; at = program.find('@', at + 1)) {
        const std::size_t end = program.find('@', at + 1);
        const std::string word = program.substr(at + 1, end - at - 1);
        const bool is_name = end != program.npos && !word.empty() && word.size() < 6 &&
                             std::all_of(word.begin(), word.end(), [](unsigned char letter) {
                               return std::isalpha(letter) != 0 || letter == '_';
                             });
        BOOST_TEST(!is_name, word);
      }
    }
  }
}
