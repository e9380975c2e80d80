#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/shell.hpp"

using nlohmann::json;
using shell::contains;
using shell::Folder;
using shell::run;

namespace {

json report_of(const std::string& arguments) {
  const auto ended = run("rayaudit audit --report json " + arguments);
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(ended.err == "");
  return json::parse(ended.out);
}

}  // namespace

BOOST_AUTO_TEST_CASE(any_number_of_threads_gives_the_same_bytes) {
  const std::string audit =
      "rayaudit audit '*/float' 'textbook/*' --family 'grazing*,tangent,rim,invalid' --cases 3000 "
      "--report json --threads ";
  const auto one = run(audit + "1");
  BOOST_TEST(one.code == 0);
  BOOST_TEST(json::parse(one.out)["audits"].size() > 30);
  BOOST_TEST((run(audit + "2") == one));
  BOOST_TEST((run(audit + "3") == one));
  BOOST_TEST((run(audit + "3 --seed 2").out != one.out));
}

BOOST_AUTO_TEST_CASE(the_oracle_confirms_all_that_it_decides) {
  const std::string audit = "rayaudit audit textbook/float textbook/double textbook/long_double ";
  const auto checked = run(audit + "--cases 500 --oracle checked");
  BOOST_TEST(checked.err == "");
  BOOST_TEST((checked == run(audit + "--cases 500 --oracle plain")));
  const auto mistaken = run(audit + "--oracle twice");
  BOOST_TEST(mistaken.code == 2);
  BOOST_TEST(mistaken.err == "rayaudit: --oracle: expected plain or checked, not twice\n");
}

BOOST_AUTO_TEST_CASE(globs_and_names_choose_what_is_audited) {
  const json report = report_of(
      "'*/float' textbook/double --shape 's*' --family grazing,anywhere --family inside "
      "--cases 100");
  std::vector<std::string> audited;
  for (const json& audit : report["audits"]) {
    BOOST_TEST(audit["shape"] == "sphere");
    BOOST_TEST(audit["cases"] == 100);
    if (audit["family"] == "inside") audited.push_back(audit["subject"]);
  }
  const std::vector<std::string> chosen = {"handout/float",          "textbook/float",
                                           "textbook/double",        "unit_direction/float",
                                           "unit_space/float",       "stable_quadratic/float",
                                           "closest_approach/float", "certified/float"};
  BOOST_TEST(audited == chosen, boost::test_tools::per_element());
  BOOST_TEST(report["audits"].size() == 24);
}

BOOST_AUTO_TEST_CASE(counts_are_read_as_people_write_them) {
  for (const std::string count : {"2000", "2_000", "2k", "2e3", "2E+3"})
    BOOST_TEST(report_of("textbook/double --shape sphere --family anywhere --cases " +
                         count)["audits"][0]["cases"] == 2000);
}

BOOST_AUTO_TEST_CASE(the_cases_audited_are_the_cases_drawn) {
  const json report = report_of("textbook/float --shape sphere --family far --cases 500 --seed 7");
  const std::string worst = report["audits"][0]["worst"]["false_hit"];
  const auto drawn =
      run("rayaudit draw --shape sphere --family far --count 500 --seed 7 --format float");
  const std::string question = worst.substr(0, worst.find(" hit"));
  BOOST_TEST(contains(drawn.out, question + "\n"), question);
}

BOOST_AUTO_TEST_CASE(the_table_tells_its_seed_without_colour) {
  const auto ended = run("rayaudit audit textbook/double --cases 100");
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(ended.err == "");
  BOOST_TEST(contains(ended.out, "seed 1"));
  BOOST_TEST(!contains(ended.out, "\033"));
}

BOOST_AUTO_TEST_CASE(reports_go_to_files_whole_and_nothing_else_is_left) {
  const Folder folder;
  folder.write("old.csv", "old");
  folder.run("ln -s old.csv link.csv");
  const auto ended = folder.run(
      "rayaudit audit textbook/float --shape disk --family rim --cases 100 --report table "
      "--report json=new.json --report csv=link.csv --report csv=/dev/null");
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(contains(ended.out, "textbook/float"));
  BOOST_TEST(json::parse(folder.text("new.json"))["audits"].size() == 1);
  BOOST_TEST(shell::line_count(folder.text("old.csv")) == 2);
  BOOST_TEST(folder.run("test -L link.csv && test -c /dev/null").code == 0);
  BOOST_TEST(folder.files() == 3);
}

BOOST_AUTO_TEST_CASE(a_reader_of_stdout_that_has_gone_costs_no_file) {
  const Folder folder;
  const auto ended = folder.run(
      "rayaudit audit textbook/float --shape disk --cases 10_000 --report table "
      "--report json=a.json | true");
  BOOST_TEST(ended.code == 141);
  BOOST_TEST(json::parse(folder.text("a.json"))["audits"].size() > 1);
  BOOST_TEST(folder.files() == 1);
}

BOOST_AUTO_TEST_CASE(a_run_that_is_stopped_leaves_the_old_report) {
  const Folder folder;
  folder.write("report.json", "old");
  // The program itself, not a shell about it, is what $! must be.
  folder.run("$RAYAUDIT audit --cases 1e12 --report json=report.json & sleep 0.5; kill $!; wait");
  folder.run("timeout -s KILL 0.5 $RAYAUDIT audit --cases 1e12 --report json=report.json");
  BOOST_TEST(folder.text("report.json") == "old");
  BOOST_TEST(folder.files() == 1);
}

BOOST_AUTO_TEST_CASE(findings_are_no_failure_unless_asked) {
  const std::string audit =
      "rayaudit audit textbook/float textbook/double --shape sphere --family far --cases 1000 ";
  BOOST_TEST(run(audit).code == 0);
  BOOST_TEST(run(audit + "--fail-on not_finite").code == 0);
  const auto failed = run(audit + "--fail-on not_finite,false_hit");
  BOOST_TEST(failed.code == 1);
  BOOST_TEST(failed.out == run(audit).out);
  BOOST_TEST(failed.err.starts_with("rayaudit: --fail-on: textbook/float on sphere, family far: "));
  BOOST_TEST(contains(failed.err,
                      " of 1,000 cases false_hit (and 1 more audit fails): rayaudit "
                      "explain --subject textbook/float 'sphere "));
  BOOST_TEST(shell::line_count(failed.err) == 1);
}

BOOST_AUTO_TEST_CASE(the_explain_command_of_a_failure_shows_it) {
  const auto ended = run(
      "rayaudit audit textbook/float --shape sphere --family far --cases 1000 --fail-on max_ulp=4 "
      "2>why >/dev/null\n"
      "eval \"$(sed 's/.*: rayaudit explain/rayaudit explain/' why)\" | grep 'the line, in float'");
  BOOST_TEST(contains(ended.out, " right "), ended);
}

BOOST_AUTO_TEST_CASE(a_convention_makes_touches_right_or_wrong) {
  const std::string audit = "textbook/double --shape sphere --family tangent --cases 200";
  BOOST_TEST(report_of(audit)["audits"][0]["touch"] > 0);
  BOOST_TEST(report_of(audit +
                       " --convention tangent=hit,start=miss,end=miss")["audits"][0]["touch"] == 0);
}

BOOST_AUTO_TEST_CASE(a_terminal_is_shown_progress_and_colour_unless_it_wants_none) {
  // script gives the program a terminal of its own; a chroot without /dev/pts has none to give.
  if (!std::filesystem::exists("/dev/pts/ptmx")) {
    BOOST_TEST(!contains(run("rayaudit audit textbook/float --cases 10").out, "\033"));
    return;
  }
  const std::string audit = "$RAYAUDIT audit --shape disk --cases 20_000";
  const auto shown = run("script -qec '" + audit + "' /dev/null");
  BOOST_TEST(contains(shown.out, " cases/s  "));
  BOOST_TEST(contains(shown.out, " s left"));
  BOOST_TEST(contains(shown.out, "\033[1m"));
  const auto plain = run("export NO_COLOR=1; script -qec '" + audit + " 2>/dev/null' /dev/null");
  BOOST_TEST(contains(plain.out, "textbook/float"));
  BOOST_TEST(!contains(plain.out, "\033"));
}
