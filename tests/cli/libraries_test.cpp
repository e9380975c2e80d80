#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/cli/shell.hpp"
#include "tests/subjects/from_environment.hpp"

/// `audit --libraries`, by a plugin that stands in Embree's place beside a copy of the program.
using nlohmann::json;
using shell::contains;
using shell::Ended;
using shell::refused;

namespace {

class Elsewhere {
 public:
  explicit Elsewhere(const std::string& plugin = "") {
    const std::string program = from_environment("RAYAUDIT");
    folder_.run("mkdir here; ln '" + program + "' here/rayaudit || cp '" + program + "' here");
    if (!plugin.empty()) folder_.run("cp '" + plugin + "' here/rayaudit-embree.so");
  }

  /// A line in which `there` is the program.
  Ended run(const std::string& line) const {
    return folder_.run("there() { here/rayaudit \"$@\"; }\n" + line);
  }
  Ended audited(const std::string& arguments) const {
    return run("there audit --cases 300 --libraries " + arguments);
  }
  std::string text(const std::string& file) const { return folder_.text(file); }
  void write(const std::string& file, const std::string& text) const { folder_.write(file, text); }

 private:
  shell::Folder folder_;
};

const Elsewhere& planted() {
  static const Elsewhere there(from_environment("granting_library"));
  return there;
}

json report_of(const std::string& arguments) {
  const Ended ended = planted().audited(arguments + " --report json");
  BOOST_TEST_REQUIRE(ended.code == 0, ended);
  return json::parse(ended.out);
}

/// The verdicts beyond rounding of a subject, over all families.
int beyond_rounding(const json& report, const std::string& subject) {
  int sum = 0;
  for (const json& audit : report.at("audits"))
    for (const json& outcome : audit.at("outcomes"))
      if (audit.at("subject") == subject) sum += outcome.value("beyond_rounding", 0);
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(all_that_are_here_are_audited_and_each_that_is_not_is_told) {
  const Ended ended = planted().audited("--report json");
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(contains(ended.err,
                      "rayaudit: ode is left out: rayaudit-ode.so is not beside the "
                      "program; it is built where there is ODE (Debian's libode-dev)\n"),
             ended);
  BOOST_TEST(!contains(ended.err, "embree is left out"), ended);
  const json report = json::parse(ended.out);
  for (const json& audit : report.at("audits"))
    BOOST_TEST(std::string(audit.at("subject")).starts_with("embree"));
}

BOOST_AUTO_TEST_CASE(without_any_nothing_is_audited) {
  const Ended ended = Elsewhere().audited("");
  BOOST_TEST(ended.code == 4, ended);
  BOOST_TEST(
      ended.err.ends_with("rayaudit: nothing to audit: no library that is asked for is here\n"),
      ended);
  BOOST_TEST(Elsewhere().audited("ode,embree/sphere").code == 4);
}

BOOST_AUTO_TEST_CASE(a_plugin_that_does_not_load_is_told) {
  const Elsewhere broken;
  broken.write("here/rayaudit-ode.so", "no shared object\n");
  const Ended ended = broken.audited("ode");
  BOOST_TEST(ended.code == 4, ended);
  BOOST_TEST(contains(ended.err, "rayaudit: ode is left out: plugin `"), ended);
  BOOST_TEST(contains(ended.err, "rayaudit-ode.so` cannot be loaded: "), ended);
}

BOOST_AUTO_TEST_CASE(a_library_a_shape_or_a_subject_may_be_named) {
  const auto audited = [](const std::string& names) {
    std::set<std::string> all;
    const json report = report_of(names + " --family unit");
    for (const json& audit : report.at("audits"))
      all.insert(std::string(audit.at("subject")) + ' ' + std::string(audit.at("shape")));
    return all;
  };
  using Names = std::set<std::string>;
  BOOST_TEST((audited("embree") == Names{"embree/float sphere", "embree_granting/float sphere",
                                         "embree_right/float sphere", "embree_right/float disk"}));
  BOOST_TEST((audited("embree/disk") == Names{"embree_right/float disk"}));
  BOOST_TEST(
      (audited("embree_right") == Names{"embree_right/float sphere", "embree_right/float disk"}));
  BOOST_TEST((audited("embree_right/sphere,embree_granting/float") ==
              Names{"embree_right/float sphere", "embree_granting/float sphere"}));
}

BOOST_AUTO_TEST_CASE(what_is_no_name_is_refused) {
  const auto refusal = planted().audited("embre");
  BOOST_TEST(refusal.code == 2, refusal);
  BOOST_TEST(contains(refusal.err, "library `embre` is not known; did you mean `embree`?"),
             refusal);
  BOOST_TEST(planted().audited("embree/spere") ==
             refused(2,
                     "--libraries: nothing is called `embree/spere`: rayaudit list libraries "
                     "tells what there is"));
  BOOST_TEST(planted().run("there audit textbook/float --libraries") ==
             refused(2, "--libraries names what is audited: it goes without other subjects"));
  BOOST_TEST(planted().run("there audit --page x").code == 2);
  planted().write("file", "");
  BOOST_TEST(planted().audited("embree --family unit --page file").code == 2);
}

BOOST_AUTO_TEST_CASE(what_rounding_excuses_is_told_from_what_it_does_not) {
  const json report = report_of("embree");
  BOOST_TEST(beyond_rounding(report, "embree_granting/float") > 100);
  BOOST_TEST(beyond_rounding(report, "embree_right/float") == 0);
  bool is_any_wrong = false;
  for (const json& audit : report.at("audits"))
    if (audit.at("subject") == "embree_right/float" && audit.at("wrong") > 0) is_any_wrong = true;
  BOOST_TEST(is_any_wrong);
}

BOOST_AUTO_TEST_CASE(the_table_tells_findings_contracts_and_times) {
  const Ended ended = planted().audited("embree");
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(contains(ended.out, "\n  embree_granting/float: Planted 1.0; declares rim=hit\n"),
             ended);
  BOOST_TEST(contains(ended.out, "\n    sphere: directions of any length "), ended);
  BOOST_TEST(contains(ended.out, "cause: assumption of the length of the direction; minimal case"),
             ended);
  BOOST_TEST(contains(ended.out, "\n     rayaudit explain --subject embree_granting/float "),
             ended);
}

BOOST_AUTO_TEST_CASE(every_other_report_can_be_had_of_it) {
  const Ended ended = planted().audited(
      "embree --family unit,length --report table --report markdown=m --report csv=c "
      "--report junit=j && cat m c j");
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(contains(ended.out, "embree_granting/float"), ended);
}

BOOST_AUTO_TEST_CASE(the_same_run_gives_the_same_page_whatever_the_threads) {
  const auto page = [](const std::string& threads) {
    const Ended ended = planted().audited(
        "embree --family unit,length --report csv=c --page page --threads " + threads);
    BOOST_TEST(ended.code == 0, ended);
    return planted().text("page/README.md");
  };
  const std::string one = page("1");
  BOOST_TEST(contains(one, "| `embree_right/float` |"), one);
  BOOST_TEST(page("3") == one);
}

BOOST_AUTO_TEST_CASE(what_has_no_program_is_not_on_the_page_and_told) {
  const Ended ended =
      planted().audited("embree_granting --family length --report csv=c --page page");
  BOOST_TEST(
      contains(ended.err, "have no program, or no sentence of their library's documentation"),
      ended);
  BOOST_TEST(!contains(planted().text("page/README.md"), "## Findings"));
  BOOST_TEST(contains(planted().text("page/README.md"), "none confirmed ("));
}

BOOST_AUTO_TEST_CASE(what_its_program_does_not_confirm_is_not_on_the_page_and_told) {
  const Ended ended = planted().audited("embree/float --family length --report csv=c --page page");
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(contains(ended.err,
                      "not confirmed, and not on the page: embree-float.sphere.wrong_t.cpp: it "),
             ended);
  BOOST_TEST(!contains(planted().text("page/README.md"), "## Findings"));
  BOOST_TEST(planted().run("[ -z \"$(ls page/programs page/trackers | grep embree)\" ]").code == 0);
}
