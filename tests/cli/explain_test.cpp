#include <boost/test/unit_test.hpp>

#include "tests/cli/shell.hpp"

using shell::contains;
using shell::Folder;
using shell::run;

namespace {

/// What is told above the table of subjects.
std::string told(const std::string& line) {
  const auto ended = run("rayaudit explain " + line);
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(ended.err == "");
  return ended.out.substr(0, ended.out.find("\n\nsubject") + 1);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_hit_is_told_as_a_closed_form_and_in_digits) {
  BOOST_TEST(
      told("'sphere 0 0 0 1 ray 0 0.5 -3 0 0 1 # half up'") ==
      "sphere    centre (0, 0, 0)  radius 1\n"
      "ray       origin (0, 0.5, -3)  direction (0, 0, 1)  range (0, inf)\n"
      "why       half up\n"
      "truth     a hit (decided by numbers of two words)\n"
      "  hit            t = (6 - sqrt(3)) / 2\n"
      "                   = 2.133974596215561353236276829247063816529...\n"
      "                   nearest double 2.133974596215561 = 0x1.1126145e9ecd5p+1\n"
      "margin    1.6e6 u in float, 8.4e14 in double, 1.7e18 in long double: whether the line "
      "meets the surface\n"
      "other roots, no answers:\n"
      "  later          t = 3.866025403784439\n");
}

BOOST_AUTO_TEST_CASE(touches_are_told_with_their_kind) {
  BOOST_TEST(contains(told("cylinder 0 0 0 0 1 0 1 ray 1 -2 0 0 0.5 0"),
                      "truth     a miss, or the touch before it, as convention has it (decided by "
                      "integers)\n"
                      "  touch, within  t = 4\n"
                      "                   nearest double 4 = 0x1p+2\n"
                      "    ... up to    t = 6\n"));
  BOOST_TEST(contains(told("sphere 0 0 0 1 ray 0 1 -3 0 0 1"), "  touch, tangent t = 3\n"));
}

BOOST_AUTO_TEST_CASE(roots_that_are_no_answers_are_told_with_their_standing) {
  BOOST_TEST(
      contains(told("disk 0 0 0 0 1 0 1 ray 3 2 0 0 -1 0"),
               "truth     a miss (decided by numbers of two words)\n"
               "margin    4.2e6 u in float, 2.3e15 in double, 4.6e18 in long double: whether "
               "it lies inside the rim\n"
               "other roots, no answers:\n"
               "  clipped        t = 2\n"));
}

BOOST_AUTO_TEST_CASE(an_invalid_case_is_told_with_its_reason) {
  BOOST_TEST(contains(told("cone 0 0 0 0 0 0 1 ray 0 0 -3 0 0 1"),
                      "truth     none, the case is invalid: base and top are the same point\n"));
}

BOOST_AUTO_TEST_CASE(words_with_signs_are_no_options) {
  BOOST_TEST(
      contains(told("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range -inf inf"), "range (-inf, inf)\n"));
}

BOOST_AUTO_TEST_CASE(every_subject_answers_and_is_judged) {
  const auto ended = run("rayaudit explain sphere 0 0 0 1 ray 0 0 -3 0 0 1");
  BOOST_TEST(contains(ended.out,
                      "subject                      answer                     verdict             "
                      "       ulps   forced  side    cause\n"));
  for (const std::string number : {"float      ", "double     ", "long_double"})
    BOOST_TEST(contains(ended.out, "textbook/" + number +
                                       "         hit 2                      right               "
                                       "          0        0  on\n"));
  BOOST_TEST(!contains(ended.out, "division_free"));
}

const std::string lost_at_a_distance =
    "'sphere -0x1.15198p-3 0x1.65ce58p-3 -0x1.b7ad3ep-1 0x1.a2d666p+1 ray 0x1.57f0d6p+13 "
    "0x1.656956p+13 0x1.60127cp+13 -0x1.a7ed0ap-1 -0x1.b876d4p-1 -0x1.b24f06p-1'";

BOOST_AUTO_TEST_CASE(a_wrong_answer_has_its_cause) {
  const auto ended = run("rayaudit explain " + lost_at_a_distance);
  const std::size_t row = ended.out.find("\ntextbook/float");
  BOOST_REQUIRE(row != std::string::npos);
  const std::string line = ended.out.substr(row, ended.out.find('\n', row + 1) - row);
  BOOST_TEST(contains(line, "false_hit no_root"), line);
  BOOST_TEST(line.ends_with(" flip"), line);
}

BOOST_AUTO_TEST_CASE(a_subject_is_followed_step_by_step_to_where_the_paths_part) {
  const auto ended = run("rayaudit explain --subject textbook/float " + lost_at_a_distance);
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(contains(ended.out,
                      "\ncause     flip at routines/quadratic_formula.hpp:20\n"
                      "          if (discriminant < N(0)) return {};\n"
                      "textbook/float, step by step:\n"));
  BOOST_TEST(contains(ended.out, "  routines/textbook.hpp:31  const N b = N(2) * dot(v, d);\n"));
  const std::size_t parted = ended.out.find("<-- the paths part");
  BOOST_REQUIRE(parted != std::string::npos);
  const std::size_t begin = ended.out.rfind('\n', parted) + 1;
  const std::string line = ended.out.substr(begin, parted - begin);
  BOOST_TEST(contains(line, " < 0: no, but exactly -"), line);
  BOOST_TEST(contains(line, " < 0: yes"), line);
}

BOOST_AUTO_TEST_CASE(a_value_that_rounding_spoilt_is_no_flip) {
  // b^2 - 4ac is negative; answered the other way, its root would be none.
  const auto ended =
      run("rayaudit explain --subject textbook/float 'sphere -0x1.ae1e3cp-4 -0x1.c09e48p-2 "
          "-0x1.dfceb2p-1 0x1.10a742p+1 ray 0x1.cec4a6p+12 -0x1.caf57p+12 0x1.8def4ep+12 "
          "-0x1.a82696p-1 0x1.a4835ep-1 -0x1.6cbd2p-1'");
  BOOST_TEST(contains(ended.out,
                      "\ncause     rounding\n"
                      "          no one comparison, answered the other way, mends it\n"));
}

BOOST_AUTO_TEST_CASE(a_declared_convention_is_held) {
  const std::string tangent = "'sphere 0 0 0 1 ray 0 1 -3 0 0 1 hit 3'";
  BOOST_TEST(contains(run("rayaudit explain " + tangent).out, " touch  "));
  BOOST_TEST(contains(run("rayaudit explain --convention tangent=miss " + tangent).out,
                      " false_hit declined "));
}

BOOST_AUTO_TEST_CASE(an_answer_that_is_declared_otherwise_has_its_cause_in_the_convention) {
  const auto ended =
      run("rayaudit explain --convention tangent=miss --subject textbook/double "
          "'sphere 0 0 0 1 ray 0 1 -3 0 0 1'");
  const std::size_t row = ended.out.find("\ntextbook/double ");
  BOOST_REQUIRE(row != ended.out.npos);
  const std::string line = ended.out.substr(row, ended.out.find('\n', row + 1) - row);
  BOOST_TEST(contains(line, " false_hit declined "), line);
  BOOST_TEST(line.ends_with(" convention"), line);
  BOOST_TEST(contains(ended.out, "\ncause     convention\n"), ended);
}

BOOST_AUTO_TEST_CASE(a_subject_that_cannot_be_followed_says_so) {
  BOOST_TEST(contains(
      run("rayaudit explain --subject certified/float sphere 0 0 0 1 ray 0 0 -3 0 0 1").out,
      "certified/float cannot be replayed step by step\n"));
  const auto other =
      run("rayaudit explain --subject division_free/float sphere 0 0 0 1 ray 0 0 -3 0 0 1");
  BOOST_TEST(other.code == 2);
  BOOST_TEST(other.err == "rayaudit: --subject: division_free/float does not answer a sphere\n");
  BOOST_TEST(run("rayaudit explain --subject textbok/float sphere 0 0 0 1 ray 0 0 -3 0 0 1").code ==
             2);
}

BOOST_AUTO_TEST_CASE(subjects_in_float_are_asked_and_judged_by_the_case_in_floats) {
  const auto ended = run("rayaudit explain sphere 0 0 0 0.1 ray 0 0 -3 0 0 1 range 0 0x1.8p+60");
  BOOST_TEST(
      contains(ended.out, "\ntextbook/float               hit 2.899999               right "),
      ended);
  BOOST_TEST(contains(ended.out,
                      " of them are asked the case rounded to float: sphere 0x0p+0 0x0p+0 0x0p+0 "
                      "0x1.99999ap-4 ray 0x0p+0 0x0p+0 -0x1.8p+1 0x0p+0 0x0p+0 0x1p+0 range "
                      "0x0p+0 0x1.8p+60\n"),
             ended);
  BOOST_TEST(!contains(run("rayaudit explain sphere 0 0 0 0.5 ray 0 0 -3 0 0 1").out, " asked "));
}

namespace {

/// Of a subject that relies on unit directions, and of what it is asked then.
const std::string of_unit_directions =
    "rayaudit explain --subject unit_direction/double --convention direction=unit ";
const std::string twice_as_long = "'sphere 0 0 0 1 ray 0 0.5 -3 0 0 2'";
const std::string normalised =
    "sphere 0x0p+0 0x0p+0 0x0p+0 0x1p+0 ray 0x0p+0 0x1p-1 -0x1.8p+1 0x0p+0 0x0p+0 0x1p+0";

}  // namespace

BOOST_AUTO_TEST_CASE(a_case_is_put_as_the_convention_has_it_and_so_followed) {
  BOOST_TEST(contains(run("rayaudit explain " + twice_as_long).out,
                      "\nunit_direction/double        hit 0.7321731235736308     wrong_t "));
  const auto ended = run(of_unit_directions + twice_as_long);
  BOOST_TEST(
      contains(ended.out, "\nunit_direction/double        hit 2.1339745962155616     right "),
      ended);
  BOOST_TEST(contains(ended.out,
                      " are asked the case posed as the convention has it: " + normalised + '\n'),
             ended);
  BOOST_TEST(!contains(ended.out, "\ncause "), ended);  // nothing is wrong
  const auto steps = [](const shell::Ended& of) {
    return of.out.substr(of.out.find("unit_direction/double, step by step:"));
  };
  BOOST_TEST(steps(ended) ==
             steps(run("rayaudit explain --subject unit_direction/double '" + normalised + "'")));
}

BOOST_AUTO_TEST_CASE(a_test_to_paste_holds_the_case_as_it_is_asked) {
  const auto ended = run(of_unit_directions + "--as gtest " + twice_as_long);
  BOOST_TEST(contains(ended.out, "/* " + normalised + " */\n/* posed as the convention has it */"),
             ended);
  BOOST_TEST(contains(ended.out, "  const double direction[3] = {0x0p+0, 0x0p+0, 0x1p+0};\n"));
  const auto in_float =
      run("rayaudit explain --as c --format float 'sphere 0 0 0 0.1 ray 0 0 -3 0 0 1 # thin'");
  BOOST_TEST(contains(in_float.out, "/* thin; rounded to float */"), in_float);
  BOOST_TEST(contains(in_float.out, "  const float radius = 0x1.99999ap-4f;\n"), in_float);
}

BOOST_AUTO_TEST_CASE(who_does_not_answer_is_told_in_its_row_and_the_others_are_asked) {
  const std::string line = " --program false sphere 0 0 0 1 ray 0 0 -3 0 0 1";
  const auto ended = run("rayaudit explain" + line);
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(ended.err == "");
  BOOST_TEST(contains(ended.out, "\ntextbook/double              hit 2 "), ended);
  BOOST_TEST(contains(ended.out, "\nfalse/double                 does not answer: its program "),
             ended);
  const auto followed = run("rayaudit explain --subject false/double" + line);
  BOOST_TEST(followed.code == 1);
  BOOST_TEST(contains(followed.out, "\nfalse/double                 does not answer: "), followed);
  BOOST_TEST(contains(followed.err, "rayaudit: false/double does not answer: "), followed);
}

BOOST_AUTO_TEST_CASE(the_answer_on_the_line_is_judged_first_in_the_format_asked_for) {
  const std::string line = "sphere 0 0 0 1 ray 0 0 -3 0 0 1 hit 0x1.000002p+1";
  const auto first_answer = [](const shell::Ended& ended) {
    const std::size_t begin = ended.out.find("cause\n") + 6;
    return ended.out.substr(begin, ended.out.find('\n', begin) - begin);
  };
  BOOST_TEST(first_answer(run("rayaudit explain '" + line + "'")) ==
             "the line, in double          hit 2.000000238418579      right                     "
             "5.4e8    3.6e8  beyond");
  BOOST_TEST(first_answer(run("rayaudit explain --format float " + line)) ==
             "the line, in float           hit 2.0000002              right                     "
             "    1    0.667  beyond");
}

BOOST_AUTO_TEST_CASE(a_line_with_a_truth_is_explained) {
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 1 -3 0 0 1 touch tangent 3 miss") ==
             told("sphere 0 0 0 1 ray 0 1 -3 0 0 1"));
}

BOOST_AUTO_TEST_CASE(a_line_of_a_file_is_explained_by_its_place) {
  const Folder folder;
  folder.write("a b.txt", "# first\ndisk 0 0 0 0 1 0 1 ray 3 2 0 0 -1 0\n");
  BOOST_TEST(folder.run("rayaudit explain 'a b.txt:2'") ==
             run("rayaudit explain disk 0 0 0 0 1 0 1 ray 3 2 0 0 -1 0"));
}

namespace {

/// A stub of a user's function that answers one t, or misses, and a main that C needs.
std::string stub(const std::string& type, const std::string& answer) {
  return "bool intersect_sphere(const " + type + " o[3], const " + type + " d[3], " + type +
         " a, " + type + " b, const " + type + " c[3], " + type + " r, " + type +
         "* t) { (void)o, (void)d, (void)a, (void)b, (void)c, (void)r, (void)t; " + answer + " }\n";
}

/// Compiles what is pasted, and runs it.
int ended_as_c(const std::string& options, const std::string& type, const std::string& answer) {
  const Folder folder;
  folder.write("stub.c", stub(type, answer));
  return folder
      .run("rayaudit explain --as c " + options +
           " > pasted.c && name=$(sed -n 's/^static void \\(.*\\)(void) {/\\1/p' pasted.c) && "
           "(cat pasted.c stub.c; echo \"int main(void) { $name(); return 0; }\") > whole.c && "
           "cc -std=c99 -Wall -Wextra -Werror whole.c -o whole -lm && ./whole")
      .code;
}

const std::string grazing = "sphere 0 0 0 1 ray 0 0.5 -3 0 0 1";
const std::string tangent = "sphere 0 0 0 1 ray 0 1 -3 0 0 1";

}  // namespace

BOOST_AUTO_TEST_CASE(a_test_to_paste_holds_the_case_in_hexadecimal_numbers) {
  const std::string wanted = R"(#include <gtest/gtest.h>
#include <cmath>

/* Yours: true and t, in units of the direction, or false. */
bool intersect_sphere(const float origin[3], const float direction[3], float t_min, float t_max, const float centre[3], float radius, float* t);

/* sphere 0x0p+0 0x0p+0 0x0p+0 0x1p+0 ray 0x0p+0 0x1p-1 -0x1.8p+1 0x0p+0 0x0p+0 0x1p+0 */
/* half up */
/* The exact truth: hit at t = 2.1339745962155613532.... */
TEST(rayaudit, sphere_eb90f071) {
  const float origin[3] = {0x0p+0f, 0x1p-1f, -0x1.8p+1f};
  const float direction[3] = {0x0p+0f, 0x0p+0f, 0x1p+0f};
  const float t_min = 0x0p+0f;
  const float t_max = INFINITY;
  const float centre[3] = {0x0p+0f, 0x0p+0f, 0x0p+0f};
  const float radius = 0x1p+0f;
  float t = 0;
  const bool hit = intersect_sphere(origin, direction, t_min, t_max, centre, radius, &t);  /* yours */
  EXPECT_TRUE((hit));
  EXPECT_TRUE((std::fabs(t - 0x1.112614p+1f) <= 0x1.6p+3f * 0x1p-22f));
}
)";
  BOOST_TEST(run("rayaudit explain --as gtest --format float '" + grazing + " # half up'") ==
             shell::printed(wanted));
}

BOOST_AUTO_TEST_CASE(a_pasted_test_in_c_holds_what_is_right_and_no_more) {
  for (const std::string type : {"float", "double", "long double"}) {
    const std::string named = type == "long double" ? "long_double" : type;
    const std::string options = "--format " + named + " '" + grazing + "'";
    const std::string exact = "*t = (" + type + ")2.133974596215561353236276829247063816529L; ";
    BOOST_TEST(ended_as_c(options, type, exact + "return true;") == 0, type);
    BOOST_TEST(ended_as_c(options, type, exact + "*t *= 1.00001; return true;") > 2, type);
    BOOST_TEST(ended_as_c(options, type, "return false;") > 2, type);
  }
}

BOOST_AUTO_TEST_CASE(a_pasted_test_of_a_touch_takes_either) {
  const std::string open = "'" + tangent + "'";
  BOOST_TEST(ended_as_c(open, "double", "return false;") == 0);
  BOOST_TEST(ended_as_c(open, "double", "*t = 3; return true;") == 0);
  BOOST_TEST(ended_as_c(open, "double", "*t = 2; return true;") > 2);
  const std::string hit = "--convention tangent=hit " + open;
  BOOST_TEST(ended_as_c(hit, "double", "return false;") > 2);
  BOOST_TEST(ended_as_c(hit, "double", "*t = 3; return true;") == 0);
  const std::string miss = "--convention tangent=miss " + open;
  BOOST_TEST(ended_as_c(miss, "double", "return false;") == 0);
  BOOST_TEST(ended_as_c(miss, "double", "*t = 3; return true;") > 2);
}

BOOST_AUTO_TEST_CASE(a_pasted_test_of_a_hit_from_inside_holds_what_is_declared_of_it) {
  const auto ends = [](const std::string& inside, const std::string& answer) {
    return ended_as_c(inside + "sphere 0 0 0 1 ray 0 0 0 0 0 1 range 0.5 inf", "double", answer);
  };
  const std::string hit = "*t = 1; return true;", start = "*t = 0.5; return true;";
  const std::string miss = "return false;";
  BOOST_TEST(ends("", hit) == 0);
  BOOST_TEST(ends("", miss) > 2);
  BOOST_TEST(ends("--convention inside=miss ", miss) == 0);
  BOOST_TEST(ends("--convention inside=miss ", hit) > 2);
  BOOST_TEST(ends("--convention inside=start ", start) == 0);
  BOOST_TEST(ends("--convention inside=start ", hit) > 2);
  BOOST_TEST(ends("--convention inside=start ", miss) > 2);
}

BOOST_AUTO_TEST_CASE(a_pasted_test_of_boost_runs) {
  const Folder folder;
  folder.write("stub.cpp", stub("double", "*t = 3; return true;"));
  const std::string build =
      "(echo '#define BOOST_TEST_MODULE pasted'; rayaudit explain --as boost '" + tangent +
      "'; cat stub.cpp) > all.cpp && c++ -std=c++17 -DBOOST_TEST_DYN_LINK all.cpp -o all "
      "-lboost_unit_test_framework && ./all";
  BOOST_TEST(folder.run(build).code == 0);
  folder.write("stub.cpp", stub("double", "*t = 2; return true;"));
  BOOST_TEST(folder.run(build).code == 201);
}

BOOST_AUTO_TEST_CASE(pasted_tests_of_other_frameworks_compile_where_they_are_there) {
  for (const auto& [framework, header] :
       {std::pair("gtest", "gtest/gtest.h"), std::pair("catch2", "catch2/catch.hpp")}) {
    std::string line = "echo '#include <" + std::string(header) +
                       ">' | c++ -std=c++17 -x c++ -E - > /dev/null || exit 0\n(";
    for (const std::string shape :
         {"disk 0 0 0 0 1 0 1 ray -3 0 0 1 0 0", "cylinder 0 0 0 0 1 0 1 ray -3 0.5 0 1 0 0",
          "cone 0 0 0 0 1 0 1 ray -3 0.5 0 1 0 0", "cone 0 0 0 0 0 0 1 ray nan 0.5 0 1 0 inf"})
      line += "rayaudit explain --as " + std::string(framework) + " '" + shape + "'; ";
    line += ") | c++ -std=c++17 -Wall -Wextra -Werror -x c++ -fsyntax-only -";
    const auto ended = run(line);
    BOOST_TEST(ended.code == 0, ended);
  }
}

BOOST_AUTO_TEST_CASE(a_test_to_paste_is_for_a_framework_that_is_known) {
  BOOST_TEST(run("rayaudit explain --as junit " + grazing).code == 2);
}
