#include <boost/test/unit_test.hpp>
#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/cli/shell.hpp"
#include "tests/subjects/from_environment.hpp"
#include "tests/subjects/processes.hpp"

using shell::contains;
using shell::Folder;
using shell::refused;
using shell::run;

namespace {

using Json = nlohmann::json;

std::string plugin(const std::string& name) { return from_environment(name.c_str()); }

/// An audit of subjects of the planted plugin, in JSON on standard output.
shell::Ended audited(const std::string& subjects, const std::string& more = "") {
  return run("rayaudit audit " + subjects + " --plugin " + plugin("misbehaving") +
             " --report json --shape sphere " + more);
}

/// What the first audit of a report says.
Json first_audit(const shell::Ended& ended) { return Json::parse(ended.out).at("audits").at(0); }

bool is_any_served() { return !processes_with("serve-plugin " + plugin("misbehaving")).empty(); }

}  // namespace

BOOST_AUTO_TEST_CASE(the_example_in_c_is_audited) {
  const auto ended = run("rayaudit audit --plugin " + plugin("mine_c") + " --cases 2000");
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(ended.err == "");
  BOOST_TEST(contains(ended.out, "\n  mine/double                  anywhere "), ended);
  BOOST_TEST(contains(ended.out, " false miss by mine: "), ended);
  BOOST_TEST(!contains(ended.out, "textbook"));
}

BOOST_AUTO_TEST_CASE(the_example_in_cpp_is_audited_and_held_to_what_it_declares) {
  const auto ended = run("rayaudit audit --report table --report json=report --plugin " +
                         plugin("mine_cpp") + " --cases 2000 && cat report");
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(contains(ended.out, "\n  mine/float declares rim=hit\n"), ended);
  const Json report = Json::parse(ended.out.substr(ended.out.find("\n{") + 1));
  BOOST_TEST(report.at("declared").at("mine/float").at("rim") == "hit");
  for (const Json& audit : report.at("audits")) {
    BOOST_TEST(audit.at("subject") == "mine/float");
    if (audit.at("family") == "rim") BOOST_TEST(audit.at("false_miss") > 0);
    if (audit.at("family") == "anywhere") BOOST_TEST(audit.at("wrong") == 0);
  }
}

BOOST_AUTO_TEST_CASE(both_examples_can_be_audited_at_once_beside_built_in_ones) {
  const auto ended =
      run("rayaudit audit 'mine/*' textbook/float --family anywhere --report csv "
          "--plugin " +
          plugin("mine_c") + " --plugin " + plugin("mine_cpp"));
  BOOST_TEST(ended.code == 0, ended);
  for (const std::string name : {"mine/double,", "mine/float,", "textbook/float,"})
    BOOST_TEST(contains(ended.out, "\n" + name), ended);
}

BOOST_AUTO_TEST_CASE(an_audit_of_a_plugin_is_the_same_for_any_number_of_threads) {
  const std::string audit = "rayaudit audit --report json --cases 5000 --plugin " +
                            plugin("mine_cpp") + " --plugin " + plugin("mine_c") + " --threads ";
  const auto one = run(audit + "1"), four = run(audit + "4");
  BOOST_TEST(one.code == 0, one);
  BOOST_TEST((one.out == four.out));
}

BOOST_AUTO_TEST_CASE(a_crash_is_a_verdict_on_its_case_and_the_audit_goes_on) {
  const auto at_13 =
      run("rayaudit draw --shape sphere --family lattice --count 3000 | "
          "grep -c ' ray 0x1.ap+3 '");
  BOOST_TEST_REQUIRE(std::stoi(at_13.out) > 2);
  BOOST_TEST_REQUIRE(std::stoi(at_13.out) < 16);
  const auto ended = audited("crashes/double throws/double exits/double formless/double",
                             "--family lattice --cases 3000");
  BOOST_TEST(ended.code == 0, ended);
  const Json audits = Json::parse(ended.out).at("audits");
  BOOST_TEST(audits.size() == 4);
  for (const Json& audit : audits) {
    BOOST_TEST(audit.at("cases") == 3000);
    BOOST_TEST(audit.at("crashed") == std::stoi(at_13.out), audit.at("subject"));
  }
}

BOOST_AUTO_TEST_CASE(a_crash_is_told_with_its_signal_and_the_command_that_shows_it_again) {
  const std::string all = "always_crashes/double --family anywhere --cases 500";
  const auto told = first_audit(audited(all));
  BOOST_TEST(told.at("crashed") == 16);
  BOOST_TEST(told.at("cases") == 16);
  BOOST_TEST(told.at("unasked") == 484);
  const Folder folder;
  const auto table =
      folder.run("rayaudit audit " + all + " --shape sphere --plugin " + plugin("misbehaving"));
  BOOST_TEST(table.code == 0, table);
  BOOST_TEST(contains(table.out,
                      "crashed by always_crashes: no answer, the process of the subject "
                      "ended, killed by SIGSEGV\n"),
             table);
  BOOST_TEST(!contains(table.out, "not reproducible"));
  BOOST_TEST(contains(table.out, "  cra-"));
  BOOST_TEST(!contains(table.out, "timed"));
  BOOST_TEST(contains(table.out, "; 484 not asked\n"), table);
  const std::size_t at =
      table.out.find("rayaudit explain --subject always_crashes/double --plugin ");
  BOOST_TEST_REQUIRE(at != table.out.npos);
  const auto shown = folder.run(table.out.substr(at, table.out.find('\n', at) - at));
  BOOST_TEST(shown.code == 0, shown);
  BOOST_TEST(
      contains(shown.out, "\nalways_crashes/double        crashed, SIGSEGV           crashed"),
      shown);
}

BOOST_AUTO_TEST_CASE(what_a_plugin_says_as_it_dies_is_passed_on_once) {
  const auto ended = audited("always_complains/double", "--family anywhere --cases 500");
  BOOST_TEST(first_audit(ended).at("crashed") == 16);
  BOOST_TEST(ended.err == "planted complaint\n");
}

BOOST_AUTO_TEST_CASE(garbage_is_told_as_such) {
  const auto told = run("rayaudit explain --plugin " + plugin("misbehaving") +
                        " --subject formless/double sphere 0 0 0 1 ray 13 0 0 1 0 0");
  BOOST_TEST(contains(told.out,
                      "\nformless/double              garbage                    crashed garbage"),
             told);
}

BOOST_AUTO_TEST_CASE(what_does_not_show_again_alone_is_told) {
  const Folder folder;
  const auto ended = folder.run(
      "CRASHED=once rayaudit audit crashes_once/double --shape sphere --family anywhere "
      "--cases 500 --report json --report table=table --plugin " +
      plugin("misbehaving"));
  BOOST_TEST(ended.code == 0, ended);
  const Json told = Json::parse(ended.out);
  BOOST_TEST(told.at("audits").at(0).at("cases") == 500);
  BOOST_TEST(told.at("audits").at(0).at("crashed") == 1);
  for (const Json& finding : told.at("findings"))
    BOOST_TEST(finding.at("reproducible") == (finding.at("verdict") != "crashed"));
  BOOST_TEST(contains(folder.text("table"),
                      "killed by SIGSEGV; not reproducible: the case\n     below, "
                      "asked alone, goes well"),
             folder.text("table"));
  const auto batches = audited("crashes_in_batches/double", "--family anywhere --cases 500");
  BOOST_TEST(first_audit(batches).at("crashed") == 1);
  BOOST_TEST(contains(batches.out, "\"reproducible\": false"));
}

BOOST_AUTO_TEST_CASE(a_plugin_that_always_hangs_is_given_up_soon_and_what_was_not_asked_is_told) {
  const auto ended = audited("always_hangs/double",
                             "--family anywhere,grazing,far,unit,axis --patience 0.1 --cases 1000");
  BOOST_TEST(ended.code == 0, ended);
  const Json told = Json::parse(ended.out);
  BOOST_TEST(told.at("audits").size() == 2);
  BOOST_TEST(told.at("audits")[0].at("timed_out") == 40);
  BOOST_TEST(told.at("audits")[1].at("timed_out") == 20);
  BOOST_TEST(told.at("audits")[1].at("unasked") == 980);
  BOOST_TEST(ended.err ==
             "rayaudit: always_hangs/double was not asked about sphere, family far, "
             "unit, axis: it crashed or hung too often\n");
}

BOOST_AUTO_TEST_CASE(with_little_patience_each_case_that_hangs_is_told) {
  const auto told =
      first_audit(audited("hangs/double", "--family lattice --cases 3000 --patience 0.2"));
  BOOST_TEST(told.at("cases") == 3000);
  BOOST_TEST(told.at("timed_out") == std::stoi(run("rayaudit draw --shape sphere --family lattice "
                                                   "--count 3000 | grep -c ' ray 0x1.ap+3 '")
                                                   .out));
  BOOST_TEST(told.at("timed_out") > 3);
}

BOOST_AUTO_TEST_CASE(patience_is_what_a_batch_is_given) {
  const std::string slow = "slow/double --family anywhere --cases 2000";
  BOOST_TEST(first_audit(audited(slow, "--patience 0.2")).at("timed_out") == 0);
  for (const std::string wrong : {"0", "-1", "nan", "1e9", "soon", "''"})
    BOOST_TEST(run("rayaudit audit --patience " + wrong) ==
               refused(2, "--patience must be a time from 0.01 to 3600 seconds, got `" +
                              (wrong == "''" ? "" : wrong) + "`"));
}

BOOST_AUTO_TEST_CASE(what_a_plugin_prints_is_in_no_report) {
  BOOST_TEST(
      !contains(audited("prints/double", "--family anywhere --cases 100").out, "printed by"));
}

BOOST_AUTO_TEST_CASE(a_plugin_that_cannot_be_audited_is_refused_before_anything_is_written) {
  const Folder folder;
  folder.write("text.so", "no shared object\n");
  const std::string audit = "rayaudit audit --report json=report --report table --plugin ";
  BOOST_TEST(folder.run(audit + "nowhere.so") ==
             refused(2, "plugin `nowhere.so` cannot be read: No such file or directory"));
  BOOST_TEST(folder.run(audit + "text.so")
                 .err.starts_with("rayaudit: plugin `text.so` cannot be loaded: "));
  BOOST_TEST(folder.run(audit + "text.so").code == 2);
  const std::string mistaken = plugin("mistaken"), named = "plugin `" + mistaken + "` ";
  BOOST_TEST(
      folder.run("FLAW=version " + audit + mistaken) ==
      refused(2, named + "is of version 7 of rayaudit/plugin.h; known here are those up to 1"));
  BOOST_TEST(folder.run("FLAW='no subjects' " + audit + mistaken) ==
             refused(2, named + "names no subjects"));
  BOOST_TEST(folder.run("FLAW=range " + audit + mistaken) ==
             refused(2, named + "has a subject `second`: its convention has the empty range from "
                                "2 to 1 for t"));
  BOOST_TEST(folder.run("FLAW='late range' " + audit + mistaken + " --convention t_max=5") ==
             refused(2,
                     "--convention leaves, with what a subject declares itself, the empty range "
                     "from 5 to 5 for t"));
  BOOST_TEST(folder.run("FLAW=crash " + audit + mistaken) ==
             refused(2, named + "was killed by SIGSEGV while it was loaded"));
  BOOST_TEST(folder.files() == 1);
}

BOOST_AUTO_TEST_CASE(a_name_that_is_taken_is_refused) {
  const std::string mistaken = plugin("mistaken"), mine = plugin("mine_c");
  BOOST_TEST(run("FLAW='taken name' rayaudit audit --plugin " + mistaken) ==
             refused(2, "--plugin " + mistaken +
                            " brings a subject `textbook/double`, and there "
                            "is one of this name already"));
  BOOST_TEST(run("rayaudit audit --plugin " + mine + " --plugin " + mine) ==
             refused(2, "--plugin " + mine +
                            " brings a subject `mine/double`, and there is one of "
                            "this name already"));
}

BOOST_AUTO_TEST_CASE(a_name_that_no_plugin_brings_is_refused_with_the_nearest) {
  BOOST_TEST(run("rayaudit audit mime/double --plugin " + plugin("mine_c")) ==
             refused(2, "subject `mime/double` is not known; did you mean `mine/double`?"));
}

BOOST_AUTO_TEST_CASE(subjects_of_a_plugin_are_listed_with_what_they_declare) {
  const auto ended = run("rayaudit list subjects --plugin " + plugin("mine_cpp") + " | tr -s ' '");
  BOOST_TEST(ended.out.starts_with("mine/float disk rim=hit\n"), ended);
  BOOST_TEST(contains(ended.out, "\ntextbook/float "));
}

BOOST_AUTO_TEST_CASE(explain_asks_a_plugin_and_holds_it_to_what_it_declares) {
  const std::string rim = " disk 0 0 0 0 0 1 1 ray 1 0 -3 0 0 1";
  const auto ended = run("rayaudit explain --plugin " + plugin("mine_cpp") + rim);
  BOOST_TEST(contains(ended.out, "\nmine/float                   hit 3                      right"),
             ended);
  const auto followed =
      run("rayaudit explain --subject mine/float --plugin " + plugin("mine_cpp") + rim + " miss");
  BOOST_TEST(contains(followed.out,
                      "\nthe line, in float           miss                       "
                      "false_miss"),
             followed);
  BOOST_TEST(contains(followed.out, "\nmine/float cannot be replayed step by step\n"), followed);
  BOOST_TEST(run("rayaudit explain --subject mine/double" + rim).code == 2);
}

BOOST_AUTO_TEST_CASE(cost_and_ladder_take_a_plugin_too) {
  const auto cost =
      run("rayaudit cost mine/double textbook/double --family anywhere --shape sphere "
          "--cases 512 --rounds 3 --all-ways --plugin " +
          plugin("mine_c"));
  BOOST_TEST(cost.code == 0, cost);
  BOOST_TEST(contains(cost.out, "mine/double"), cost);
  const auto ladder = run("rayaudit ladder --cases 64 --plugin " + plugin("mine_c"));
  BOOST_TEST(ladder.code == 0, ladder);
  BOOST_TEST(contains(ladder.out, "mine/double"), ladder);
  const auto untimed =
      run("rayaudit cost always_crashes/double --family anywhere --shape sphere "
          "--rounds 3 --plugin " +
          plugin("misbehaving"));
  BOOST_TEST(untimed.code == 1);
  BOOST_TEST(untimed.err == "rayaudit: always_crashes/double does not answer: its plugin " +
                                plugin("misbehaving") + " was killed by SIGSEGV\n");
}

BOOST_AUTO_TEST_CASE(no_process_is_left_after_an_audit_nor_after_its_sudden_end) {
  audited("crashes/double leaves_a_child/double", "--family lattice --cases 5000");
  BOOST_TEST(!is_any_served());
  const std::string hanging =
      "\"$RAYAUDIT\" audit always_hangs/double --patience 60 "
      "--report json=report --plugin " +
      plugin("misbehaving") +
      " & program=$!\n"
      "for i in $(seq 100); do sleep 0.05; "
      "[ -n \"$(cat /proc/$program/task/*/children)\" ] && break; done\n"
      "sleep 0.5; echo $program; kill -";
  for (const std::string signal : {"KILL", "TERM", "INT"}) {
    const Folder folder;
    BOOST_TEST(!is_any_served());
    const auto ended = folder.run("set -m\n" + hanging + signal + " $program; wait $program");
    BOOST_TEST(ended.code > 128, ended);
    BOOST_TEST(comes_true([] { return !is_any_served(); }), signal);
    BOOST_TEST(folder.files() == 0);
  }
}

BOOST_AUTO_TEST_CASE(a_convention_may_be_stated_for_all_subjects) {
  const std::string audit =
      "rayaudit audit mine/double --shape sphere --family inside --cases 200 "
      "--report json --plugin " +
      plugin("mine_c") + " --convention ";
  const Json open = Json::parse(run(audit + "tangent=hit").out);
  BOOST_TEST(open.at("audits")[0].at("wrong") == 0);
  BOOST_TEST(open.at("convention").at("tangent") == "hit");
  const Json missed = Json::parse(run(audit + "inside=miss").out);
  BOOST_TEST(missed.at("audits")[0].at("false_hit") == 200);
  BOOST_TEST(missed.at("convention").at("inside") == "miss");
  const Json whole = Json::parse(run(audit + "ray=line,direction=unit,t_max=1e9").out);
  BOOST_TEST(whole.at("convention").at("ray") == "line");
  BOOST_TEST(whole.at("convention").at("direction") == "unit");
  BOOST_TEST(whole.at("convention").at("t_max") == 1e9);
  const auto table =
      run("rayaudit audit textbook/float --shape sphere --family anywhere --cases 10 "
          "--convention inside=start,t_min=0.5");
  BOOST_TEST(contains(table.out, "; declared: inside=start,t_min=0.5"), table);
}

BOOST_AUTO_TEST_CASE(a_convention_that_cannot_be_read_is_refused) {
  const auto refusal = [](const std::string& words, const std::string& why) {
    BOOST_TEST(run("rayaudit audit --convention " + words) == refused(2, why));
  };
  refusal("inside=hot", "word for inside `hot` is not known; did you mean `hit`?");
  refusal("direction=unti", "kind of direction `unti` is not known; did you mean `unit`?");
  refusal("ray=lines", "kind of ray `lines` is not known; did you mean `line`?");
  refusal("t_min=soon", "--convention: expected a number for t_min, got `soon`");
  refusal("t_max=nan", "--convention: expected a number for t_max, got `nan`");
}
