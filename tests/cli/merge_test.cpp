#include <boost/test/unit_test.hpp>

#include "tests/cli/shell.hpp"
#include "tests/subjects/from_environment.hpp"

using shell::contains;
using shell::Folder;
using shell::refused;

namespace {

/// An audit with wrong answers of every kind, in four chunks of cases.
const std::string audit =
    "rayaudit audit textbook/float handout/double certified/float "
    "--family far,rim,tangent,invalid,anywhere --cases 3500 --seed 7 ";

/// Its shards, as 1.shard, 2.shard and 3.shard.
void run_shards(const Folder& folder, const std::string& arguments = "") {
  const auto ended = folder.run("for i in 1 2 3; do " + audit + arguments +
                                " --shard $i/3 --threads $i --report shard=$i.shard || exit; done");
  BOOST_TEST(ended == shell::printed(""));
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_report_of_merged_shards_is_that_of_one_run_to_the_byte) {
  const Folder folder;
  run_shards(folder);
  for (const std::string report : {"table", "json", "csv", "html", "junit", "markdown"}) {
    const auto at_once = folder.run(audit + "--report " + report);
    if (at_once.code == 2 && report == "html") continue;  // a build without npm has no pages
    BOOST_TEST(at_once.code == 0, report << at_once);
    const auto merged = folder.run("rayaudit merge 3.shard 1.shard 2.shard --report " + report);
    BOOST_TEST((merged == at_once), report << ": " << merged.err);
    BOOST_TEST(at_once.out.size() > 1000u, report);
  }
}

BOOST_AUTO_TEST_CASE(shards_of_a_plugin_need_it_again_and_the_same) {
  const Folder folder;
  folder.run(std::string("cp '") + from_environment("mine_c") + "' mine.so; cp mine.so other.so");
  const std::string mine = "rayaudit audit --plugin ./mine.so --cases 2500 --family far,anywhere ";
  const auto sharded =
      folder.run("for i in 1 2; do " + mine + "--shard $i/2 --report shard=$i.shard; done");
  BOOST_TEST(sharded == shell::printed(""));
  BOOST_TEST(folder.run("rayaudit merge 1.shard 2.shard") ==
             refused(2,
                     "`1.shard` is of no use here: subject `mine/double` is not here: it was "
                     "brought by --plugin "
                     "./mine.so, which is to be given again"));
  const std::string merge = "rayaudit merge 1.shard 2.shard --report json --plugin ";
  const auto at_once = folder.run(mine + "--report json");
  BOOST_TEST(at_once.code == 0, at_once);
  BOOST_TEST((folder.run(merge + "./mine.so") == at_once));
  BOOST_TEST(folder.run(merge + "./other.so").code == 0);
  folder.run("echo changed >>mine.so");  // what comes after its end is not loaded
  BOOST_TEST(
      folder.run(merge + "./mine.so") ==
      refused(
          2,
          "`1.shard` is of no use here: subject `mine/double` is not what it was: format, shapes, "
          "conventions or what it is made of differ"));
}

BOOST_AUTO_TEST_CASE(bounds_are_the_shards_and_judged_when_all_are_there) {
  const Folder folder;
  folder.write("rows.txt", "textbook/float * far max_ulp 4 wrong 0 observed\n");
  run_shards(folder, "--bounds rows.txt");
  const auto at_once = folder.run(audit + "--bounds rows.txt --report json --report junit=a.xml");
  BOOST_TEST(at_once.code == 1);
  const auto merged = folder.run("rayaudit merge [123].shard --report json --report junit=b.xml");
  BOOST_TEST((merged == at_once), merged.err << at_once.err);
  BOOST_TEST(folder.text("a.xml") == folder.text("b.xml"));
}

BOOST_AUTO_TEST_CASE(what_needs_all_cases_is_asked_of_the_merge) {
  const Folder folder;
  run_shards(folder);
  const std::string what = "--fail-on max_ulp=4 --report csv=/dev/null ";
  const auto at_once = folder.run(audit + what + "--write-bounds -");
  BOOST_TEST(at_once.code == 1);
  const auto merged = folder.run("rayaudit merge *.shard " + what + "--write-bounds -");
  BOOST_TEST(merged.err == at_once.err);
  const auto rows = [](const std::string& text) { return text.substr(text.find("# SUBJECT")); };
  BOOST_TEST(rows(merged.out) == rows(at_once.out));
  folder.run(audit + "--report json=old.json");
  const auto held = folder.run("rayaudit merge *.shard --baseline old.json --report csv=/dev/null");
  BOOST_TEST(held.code == 0);
  BOOST_TEST(contains(held.err, "--baseline old.json: 0 broke, 0 fixed in "), held.err);
}

BOOST_AUTO_TEST_CASE(a_shard_writes_nothing_but_itself) {
  const auto told = [](const std::string& arguments) {
    const Folder folder;
    const auto ended = folder.run("rayaudit audit --cases 10 --shard 1/2 " + arguments);
    BOOST_TEST(folder.files() == 0);
    return ended;
  };
  const std::string needs = " needs the cases of all shards: give it to `rayaudit merge`";
  BOOST_TEST(told("--report json=a --report shard=b") == refused(2, "--report json=a" + needs));
  BOOST_TEST(told("--report shard=b --fail-on wrong_t") == refused(2, "--fail-on" + needs));
  BOOST_TEST(told("--report shard=b --baseline a") == refused(2, "--baseline" + needs));
  BOOST_TEST(told("--report shard=b --write-bounds a") == refused(2, "--write-bounds" + needs));
  BOOST_TEST(told("") == refused(2, "--shard needs one --report shard=FILE, for `rayaudit merge`"));
  BOOST_TEST(shell::run("rayaudit audit --report shard=a") ==
             refused(2, "--report shard=FILE goes with `rayaudit audit --shard i/n`"));
}

BOOST_AUTO_TEST_CASE(a_shard_that_is_none_is_refused) {
  const auto told = [](const std::string& text) {
    return shell::run("rayaudit audit --shard '" + text + "' --report shard=a");
  };
  BOOST_TEST(told("3") ==
             refused(2, "--shard: expected i/n, as 1/3 for the first of three, got `3`"));
  for (const std::string text : {"0/3", "4/3", "1/0", "-1/3", "a/b", "1/", "/3", "1/2/3"}) {
    BOOST_TEST(told(text).code == 2, text);
    BOOST_TEST(shell::line_count(told(text).err) == 1, text);
  }
}

BOOST_AUTO_TEST_CASE(more_shards_than_chunks_are_the_same_run) {
  const Folder folder;
  const std::string small =
      "rayaudit audit textbook/float --shape sphere --family far --cases 1500 --seed 7 ";
  folder.run("for i in 1 2 3 4 5; do " + small + "--shard $i/5 --report shard=$i.shard; done");
  BOOST_TEST(
      (folder.run("rayaudit merge *.shard --report json") == folder.run(small + "--report json")));
}

BOOST_AUTO_TEST_CASE(shards_that_do_not_make_a_run_are_refused) {
  const Folder folder;
  run_shards(folder);
  BOOST_TEST(folder.run("rayaudit merge 1.shard 3.shard") == refused(2, "shard 2 of 3 is missing"));
  BOOST_TEST(folder.run("cp 1.shard copy\nrayaudit merge 1.shard 2.shard copy") ==
             refused(2, "`1.shard` and `copy` are both shard 1 of 3"));
  BOOST_TEST(folder.run("head -c 1000 2.shard >cut\nrayaudit merge 1.shard cut 3.shard") ==
             refused(2, "`cut` is not whole, or was changed"));
  BOOST_TEST(folder.run("echo hello >other\nrayaudit merge other") ==
             refused(2, "`other` is no shard of an audit"));
  BOOST_TEST(folder.run("rayaudit merge nowhere") ==
             refused(2, "`nowhere` cannot be read: No such file or directory"));
  folder.run("rayaudit audit textbook/float --cases 10 --shard 2/3 --report shard=small");
  BOOST_TEST(folder.run("rayaudit merge 1.shard small 3.shard") ==
             refused(2,
                     "`small` is no shard of the same run as `1.shard`: its cases is 10, not "
                     "3500"));
  BOOST_TEST(folder.run("rayaudit merge").code == 2);
}
