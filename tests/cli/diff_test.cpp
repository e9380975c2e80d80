#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/shell.hpp"

using nlohmann::json;
using shell::contains;
using shell::Folder;
using shell::refused;

namespace {

const std::string audit =
    "rayaudit audit textbook/float textbook/double stable_quadratic/float --shape sphere,cone "
    "--family far,anywhere,tangent --cases 1500 ";

/// A folder with old.json, and new.json that says of its first audit with wrong answers what a
/// change made of it.
struct Two : Folder {
  Two() { run(audit + "--report json=old.json\ncp old.json new.json"); }

  template <class Change>
  void change(const Change& change) const {
    json report = json::parse(text("new.json"));
    for (json& each : report["audits"]) {
      if (each["outcomes"].empty()) continue;
      change(each);
      break;
    }
    write("new.json", report.dump());
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_same_run_again_broke_nothing) {
  const Two two;
  const auto ended = two.run("rayaudit diff old.json new.json");
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(ended.err == "");
  BOOST_TEST(contains(ended.out, "\n0 broke, 0 fixed in "), ended.out);
}

BOOST_AUTO_TEST_CASE(what_broke_makes_the_exit_code_1_and_what_is_fixed_does_not) {
  const Two two;
  two.change([](json& first) {
    first["outcomes"][0]["count"] = first["outcomes"][0]["count"].get<int>() + 1;
  });
  const auto worse = two.run("rayaudit diff old.json new.json");
  BOOST_TEST(worse.code == 1);
  BOOST_TEST(worse.err == "");
  BOOST_TEST(contains(worse.out, "\nBroke\n  textbook/float on sphere, family "), worse.out);
  const auto better = two.run("rayaudit diff new.json old.json");
  BOOST_TEST(better.code == 0);
  BOOST_TEST(contains(better.out, "\nFixed\n  textbook/float on sphere, family "), better.out);
}

BOOST_AUTO_TEST_CASE(the_explain_command_of_what_broke_shows_it) {
  const Two two;
  two.change([](json& first) { first["outcomes"] = json::array(); });
  const auto ended = two.run(
      "rayaudit diff new.json old.json >changes\n"
      "eval \"$(sed -n 's/^    rayaudit/rayaudit/p' changes | head -1)\" | grep false");
  BOOST_TEST(ended.code == 0, ended);
}

BOOST_AUTO_TEST_CASE(a_renamed_subject_is_held_against_itself) {
  const Two two;
  two.run(
      "rayaudit audit textbook/double --shape sphere --family far --cases 1500 --report "
      "json=b.json");
  two.run("sed -i 's-textbook/double-other/float-g' b.json");
  const auto ended =
      two.run("rayaudit diff old.json b.json --map textbook/double=other/float --report json");
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(json::parse(ended.out)["compared"] == 1);
  BOOST_TEST(two.run("rayaudit diff old.json b.json --map a=b").code == 2);
}

BOOST_AUTO_TEST_CASE(runs_that_were_not_asked_the_same_are_refused) {
  const Two two;
  const auto told = [&](const std::string& arguments) {
    return two.run(audit + arguments +
                   " --report json=other.json\nrayaudit diff old.json other.json");
  };
  const std::string head = "`old.json` and `other.json` cannot be compared: ";
  BOOST_TEST(told("--seed 2") == refused(2, head + "seed 1 there, 2 here"));
  BOOST_TEST(told("--difficulty 3") == refused(2, head + "difficulty null there, 3 here"));
  BOOST_TEST(told("--convention tangent=miss").code == 2);
}

BOOST_AUTO_TEST_CASE(what_is_no_report_is_refused) {
  const Two two;
  BOOST_TEST(two.run("echo hello >a\nrayaudit diff a new.json") ==
             refused(2, "`a` is no JSON at byte 1"));
  BOOST_TEST(two.run("head -c 5000 old.json >a\nrayaudit diff a new.json") ==
             refused(2, "`a` breaks off after 5000 bytes: it is not whole"));
  BOOST_TEST(two.run("rayaudit diff old.json nowhere") ==
             refused(2, "`nowhere` cannot be read: No such file or directory"));
  BOOST_TEST(two.run("rayaudit ladder textbook/float --shape sphere --family far --cases 10 "
                     "--report json=a\nrayaudit diff a a") ==
             refused(2, "`a` is a report of `ladder`, not of an audit"));
  BOOST_TEST(two.run("truncate -s 1200M a\nrayaudit diff a a") ==
             refused(2, "`a` is larger than a gigabyte: no report is"));
  BOOST_TEST(two.run("rayaudit diff old.json").code == 2);
}

BOOST_AUTO_TEST_CASE(where_nothing_is_in_common_the_exit_code_is_4) {
  const Two two;
  const auto told = two.run(
      "rayaudit audit handout/float --shape sphere --family far --cases 1500 --report json=a.json\n"
      "rayaudit diff old.json a.json");
  BOOST_TEST(told == refused(4,
                             "nothing was compared: `old.json` and `a.json` have no subject, "
                             "shape and family in common; --map OLD=NEW renames a subject"));
  BOOST_TEST(two.run("rayaudit audit handout/float --shape disk --family far --cases 1500 "
                     "--baseline old.json")
                 .code == 4);
}

BOOST_AUTO_TEST_CASE(reports_of_a_diff_go_to_files) {
  const Two two;
  const auto ended = two.run(
      "rayaudit diff old.json new.json --report markdown=a.md --report json=a.json --report table");
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(contains(two.text("a.md"), "**rayaudit: 0 broke, 0 fixed in "));
  BOOST_TEST(json::parse(two.text("a.json"))["broke"].empty());
}

BOOST_AUTO_TEST_CASE(an_audit_is_held_against_a_baseline_in_one_go) {
  const Two two;
  const auto same = two.run(audit + "--baseline old.json --report csv=/dev/null");
  BOOST_TEST(same.code == 0);
  BOOST_TEST(contains(same.err, "rayaudit: --baseline old.json: 0 broke, 0 fixed in "), same.err);
  two.change([](json& first) { first["outcomes"] = json::array(); });
  const auto worse = two.run(audit + "--baseline new.json --report json=this.json");
  BOOST_TEST(worse.code == 1);
  BOOST_TEST(worse.err.starts_with("rayaudit: broke: textbook/float on sphere, family "),
             worse.err);
  BOOST_TEST(contains(worse.err, ": rayaudit explain --subject textbook/float '"), worse.err);
  BOOST_TEST(two.text("this.json") == two.text("old.json"));
}

BOOST_AUTO_TEST_CASE(a_baseline_that_will_not_do_is_refused_before_anything_is_run) {
  const Two two;
  BOOST_TEST(two.run("rayaudit audit --cases 1e12 --baseline old.json") ==
             refused(2,
                     "`old.json` and `this run` cannot be compared: cases 1500 there, "
                     "1000000000000 here"));
  BOOST_TEST(two.run("rayaudit audit --cases 1e12 --baseline nowhere") ==
             refused(2, "`nowhere` cannot be read: No such file or directory"));
}
