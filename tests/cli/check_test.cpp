#define BOOST_TEST_MODULE check
#include <boost/test/unit_test.hpp>
#include <filesystem>

#include "tests/cli/shell.hpp"

using shell::contains;
using shell::Folder;
using shell::refused;
using shell::run;

namespace {

const std::string corpus =
    "'" + (std::filesystem::absolute(__FILE__).parent_path() / "../../data/cases").string() + "'";

const std::string found = "rayaudit audit handout/float --shape sphere --cases 500 --save-cases ";

}  // namespace

BOOST_AUTO_TEST_CASE(saved_cases_are_lines_with_their_truth_and_reason) {
  const Folder folder;
  BOOST_TEST(folder.run(found + "found.txt").code == 0);
  const std::string text = folder.text("found.txt");
  BOOST_TEST(contains(text, " # handout/float: false_miss, formula"), text);
  BOOST_TEST(contains(text, "; it said miss\n"), text);
  BOOST_TEST(folder.run("rayaudit truth found.txt | diff found.txt -") == shell::printed(""));
}

BOOST_AUTO_TEST_CASE(every_report_and_file_tells_the_same_minimal_case) {
  const Folder folder;
  const auto ended = folder.run(found + "found.txt --report table --report json=found.json");
  BOOST_TEST(contains(ended.out, "\n     minimal: formula"), ended);
  const std::size_t begin = ended.out.find("rayaudit explain --subject handout/float '") + 42;
  const std::string line = ended.out.substr(begin, ended.out.find('\'', begin) - begin);
  BOOST_TEST(contains(folder.text("found.json"), "\"minimal\": \"" + line + "\""), line);
  const std::string question = line.substr(0, line.find(" 0x0p+0 at"));
  BOOST_TEST(contains(folder.text("found.txt"), question), question);
}

BOOST_AUTO_TEST_CASE(a_case_that_is_there_already_is_not_added_again) {
  const Folder folder;
  folder.run(found + "found.txt");
  const std::string once = folder.text("found.txt");
  folder.run(found + "found.txt");
  BOOST_TEST(folder.text("found.txt") == once);
  folder.write("found.txt", "# mine\nsphere 0 0 0 1 ray 0 0 -3 0 0 1");
  folder.run(found + "found.txt");
  BOOST_TEST(folder.text("found.txt") == "# mine\nsphere 0 0 0 1 ray 0 0 -3 0 0 1\n" + once);
}

BOOST_AUTO_TEST_CASE(programs_that_save_at_the_same_time_lose_nothing) {
  const Folder folder;
  folder.run(found +
             "both.txt &\n rayaudit audit handout/float --shape disk --cases 500 "
             "--save-cases both.txt\n wait");
  const std::string text = folder.text("both.txt");
  BOOST_TEST(contains(text, "\nsphere ") + text.starts_with("sphere ") > 0);
  BOOST_TEST(contains(text, "\ndisk ") + text.starts_with("disk ") > 0);
  BOOST_TEST(folder.files() == 1);
}

BOOST_AUTO_TEST_CASE(a_file_that_holds_no_cases_is_not_added_to) {
  const Folder folder;
  folder.write("notes.txt", "dear diary\n");
  const auto ended = folder.run(found + "notes.txt");
  BOOST_TEST(ended.code == 2);
  BOOST_TEST(contains(ended.err, "rayaudit: notes.txt:1: "), ended);
  BOOST_TEST(ended.out == "");
  BOOST_TEST(folder.text("notes.txt") == "dear diary\n");
}

BOOST_AUTO_TEST_CASE(what_an_audit_saved_fails_the_subject_that_it_found) {
  const Folder folder;
  folder.run(found + "found.txt");
  const auto ended = folder.run("rayaudit check found.txt --subject handout/float,certified/float");
  BOOST_TEST(ended.code == 1);
  BOOST_TEST(contains(ended.out, "  found.txt:1: "), ended);
  BOOST_TEST(contains(ended.out, "\n    rayaudit explain --subject handout/float '"), ended);
  BOOST_TEST(contains(ended.out, "\ncertified/float: 0 of "), ended);
}

BOOST_AUTO_TEST_CASE(the_corpus_holds_for_a_sound_subject) {
  const auto ended = run("rayaudit check " + corpus + "/*.txt --subject certified/double");
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(ended.out.starts_with("certified/double: 0 of 5"), ended);
  BOOST_TEST(contains(ended.out, " touched"), ended);
}

BOOST_AUTO_TEST_CASE(a_case_is_asked_in_the_format_and_as_the_convention_has_it) {
  const Folder folder;
  folder.write("a.txt", "sphere 0 0 0 1 ray 0 0.1 -3 0 0 2\n");
  BOOST_TEST(contains(folder.run("rayaudit check a.txt --subject textbook/float").out,
                      "textbook/float: 0 of 1 cases wrong, 1 rounded to float or posed"));
  // It relies on unit directions: asked so, it is right.
  BOOST_TEST(folder.run("rayaudit check a.txt --subject unit_direction/double").code == 1);
  BOOST_TEST(folder
                 .run("rayaudit check a.txt --subject unit_direction/double --convention "
                      "direction=unit")
                 .code == 0);
}

BOOST_AUTO_TEST_CASE(the_reason_on_a_line_is_told_with_what_is_wrong) {
  const Folder folder;
  folder.write("a.txt", "\nsphere 0 0 0 1 ray 0 0 -3 0 0 2 hit 1 # lost in spring\n");
  const auto ended = folder.run("rayaudit check a.txt --subject handout/double");
  BOOST_TEST(ended.code == 1);
  BOOST_TEST(contains(ended.out, "  a.txt:2: false_miss # lost in spring\n"), ended);
}

BOOST_AUTO_TEST_CASE(a_truth_that_is_none_is_the_mistake_of_the_file) {
  const Folder folder;
  folder.write("a.txt", "sphere 0 0 0 1 ray 0 0 -3 0 0 1 miss\n");
  BOOST_TEST(folder.run("rayaudit check a.txt --subject textbook/double") ==
             refused(2,
                     "a.txt:1: `miss` is not the truth of this case: hit 0x1p+1; `rayaudit truth` "
                     "writes it"));
}

BOOST_AUTO_TEST_CASE(nothing_to_check_is_told) {
  const Folder folder;
  folder.write("a.txt", "# none yet\n");
  folder.write("b.txt", "sphere 0 0 0 1 ray 0 0 -3 0 0 1\n");
  BOOST_TEST(folder.run("rayaudit check a.txt --subject textbook/double") ==
             refused(4, "a.txt has no case to check"));
  BOOST_TEST(
      folder.run("rayaudit check b.txt --subject division_free/double") ==
      refused(4, "nothing was checked: no chosen subject answers the shapes of these cases"));
  BOOST_TEST(folder.run("rayaudit check b.txt") ==
             refused(2,
                     "check: name what to check, as in --subject 'textbook/*' or "
                     "--plugin ./libmine.so"));
  BOOST_TEST(folder.run("rayaudit check").code == 2);
  BOOST_TEST(contains(folder.run("rayaudit check no.txt --subject textbook/double").err,
                      "`no.txt` cannot be read"));
}
