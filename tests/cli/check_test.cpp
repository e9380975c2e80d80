#include <boost/test/unit_test.hpp>
#include <filesystem>

#include "tests/cli/shell.hpp"

using shell::contains;
using shell::Folder;
using shell::refused;
using shell::run;

namespace {

const std::string corpus = "'" RAYAUDIT_DATA "/cases'";

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
  BOOST_TEST(ended.out.starts_with("certified/double: 0 of 8"), ended);
  BOOST_TEST(contains(ended.out, " touched"), ended);
}

BOOST_AUTO_TEST_CASE(a_case_is_asked_in_the_format_and_as_the_convention_has_it) {
  const Folder folder;
  folder.write("a.txt", "sphere 0 0 0 1 ray 0 0.1 -3 0 0 2\n");
  BOOST_TEST(folder.run("rayaudit check a.txt --subject textbook/float") ==
             shell::printed("textbook/float: 0 of 1 cases wrong, 1 rounded to float\n"));
  // It relies on unit directions: asked so, it is right.
  BOOST_TEST(folder.run("rayaudit check a.txt --subject unit_direction/double").code == 1);
  const std::string asked_so = "rayaudit check a.txt --convention direction=unit --subject ";
  BOOST_TEST(folder.run(asked_so + "unit_direction/double") ==
             shell::printed("unit_direction/double: 0 of 1 cases wrong, 1 posed as its convention "
                            "has it\n"));
  BOOST_TEST(folder.run(asked_so + "unit_direction/float") ==
             shell::printed("unit_direction/float: 0 of 1 cases wrong, 1 rounded to float, 1 posed "
                            "as its convention has it\n"));
}

BOOST_AUTO_TEST_CASE(what_was_asked_already_is_asked_as_it_is) {
  const Folder folder;
  folder.run(
      "rayaudit audit unit_direction/float --convention direction=unit --cases 2000 "
      "--save-cases found.txt");
  const auto ended = folder.run(
      "rayaudit check found.txt --subject unit_direction/float --convention direction=unit");
  BOOST_TEST(ended.code == 1, ended);
  BOOST_TEST(!contains(ended.out, " posed "), ended);
  BOOST_TEST(!contains(ended.out, " rounded "), ended);
}

BOOST_AUTO_TEST_CASE(of_a_file_only_the_shapes_that_are_named_are_checked) {
  const Folder folder;
  folder.write("a.txt",
               "sphere 0 0 0 1 ray 0 0 -3 0 0 1\ndisk 0 0 0 0 0 1 1 ray 0 0 -3 0 0 1\n"
               "cone 0 0 0 0 1 0 1 ray -3 0.5 0 1 0 0\n");
  const std::string check = "rayaudit check a.txt --subject textbook/double --shape ";
  const auto told = [](const std::string& count) {
    return shell::printed("textbook/double: 0 of " + count + " cases wrong\n");
  };
  BOOST_TEST(folder.run(check + "disk") == told("1"));
  BOOST_TEST(folder.run(check + "sphere,co*") == told("2"));
  BOOST_TEST(folder.run(check + "cylinder") ==
             refused(4, "a.txt has no case to check of a chosen shape"));
  BOOST_TEST(folder.run(check + "shpere").code == 2);
}

BOOST_AUTO_TEST_CASE(a_wrong_answer_that_does_not_repeat_alone_is_told) {
  const Folder folder;
  folder.write("a.txt", "sphere 0 0 0 1 ray 0 0 -3 0 0 1\nsphere 0 0 0 1 ray 0 0 -4 0 0 1\n");
  // Asked for many it misses all; asked for one it says where, and rightly of the first only.
  folder.write(
      "mine.awk",
      "{ line[NR] = $0 }\n"
      "END { for (i = 1; i <= NR; ++i) print line[i], (NR > 1 ? \"miss\" : \"hit 2\") }\n");
  const auto ended = folder.run("rayaudit check a.txt --program 'awk -f mine.awk'");
  BOOST_TEST(ended.code == 1, ended);
  BOOST_TEST(contains(ended.out, "\n  a.txt:1: false_miss, not reproducible\n"), ended);
  const auto steady = folder.run("rayaudit check a.txt --program 'sed s/$/\\ miss/'");
  BOOST_TEST(contains(steady.out, "\n  a.txt:1: false_miss\n"), steady);
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

BOOST_AUTO_TEST_CASE(a_truth_is_held_to_an_ulp) {
  const Folder folder;
  const auto code = [&](const std::string& t) {
    folder.write("a.txt", "sphere 0 0 0 1 ray 0 0 -3 0 0 1 hit " + t + "\n");
    return folder.run("rayaudit check a.txt --subject textbook/double").code;
  };
  BOOST_TEST(code("0x1p+1") == 0);
  BOOST_TEST(code("0x1.0000000000001p+1") == 0);
  BOOST_TEST(code("0x1.0000000000002p+1") == 2);
  BOOST_TEST(code("2.01") == 2);
}

BOOST_AUTO_TEST_CASE(cases_are_not_saved_to_standard_output) {
  const Folder folder;
  BOOST_TEST(folder.run(found + "-") ==
             refused(2, "--save-cases -: expected a file; standard output is a report's"));
  BOOST_TEST(folder.files() == 0);
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
