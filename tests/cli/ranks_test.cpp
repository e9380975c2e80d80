#include <boost/test/unit_test.hpp>

#include "tests/cli/shell.hpp"
#include "tests/subjects/from_environment.hpp"

using shell::contains;
using shell::Folder;

namespace {

/// How a shell line begins in which `ranks N ...` is mpirun, with leave to start more processes
/// than there are processors, and to do it as root. What Open MPI never gives back is no leak of
/// ours.
const std::string start =
    "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1\n"
    "export ASAN_OPTIONS=detect_leaks=0\n"
    "ranks() { \"$MPIRUN\" --oversubscribe -n \"$@\"; }\n";

/// An audit with wrong answers of every kind on all shapes, whose last chunk of cases is not full.
const std::string audit =
    " audit textbook/float handout/double certified/float "
    "--family far,rim,tangent,invalid,anywhere --cases 3500 --seed 7 ";
/// One that takes about a second.
const std::string short_audit = " audit textbook/float --shape sphere --cases 1500 ";

shell::Ended by_ranks(const Folder& folder, int count, const std::string& arguments) {
  return folder.run(start + "ranks " + std::to_string(count) + " \"$RAYAUDIT\"" + arguments);
}

/// mpirun has words of its own; these are the program's.
std::string said(const shell::Ended& ended) {
  std::istringstream lines(ended.err);
  std::string ours;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("rayaudit: ")) ours += line + '\n';
  return ours;
}

/// Compares what is said, and what is written to each report's file, with that of one process.
void check_same(const Folder& folder, int count, const std::string& arguments,
                const std::vector<std::string>& reports) {
  std::string files, orders;
  for (const std::string& report : reports)
    files += report + ' ', orders += "--report " + report + "=" + report + ' ';
  const auto at_once = folder.run("rayaudit" + arguments + orders);
  folder.run("rm -rf one; mkdir one; mv " + files + "one");
  const auto many = by_ranks(folder, count, arguments + orders);
  BOOST_TEST(many.code == at_once.code, many);
  BOOST_TEST(many.out == at_once.out);
  BOOST_TEST(said(many) == at_once.err);
  for (const std::string& report : reports) {
    BOOST_TEST(folder.text(report).size() > 1000u, report);
    BOOST_TEST((folder.text(report) == folder.text("one/" + report)), report);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_report_of_ranks_is_that_of_one_process_to_the_byte) {
  for (const int count : {2, 4}) {
    const Folder folder;
    check_same(folder, count, audit + "--report table ",
               {"table", "json", "csv", "junit", "markdown"});
  }
}

BOOST_AUTO_TEST_CASE(more_ranks_than_chunks_are_the_same_run) {
  check_same(Folder(), 4, short_audit + "--report table ", {"json"});
}

BOOST_AUTO_TEST_CASE(what_breaks_a_bound_is_told_once_and_is_the_exit_code) {
  const Folder folder;
  folder.write("rows.txt", "textbook/float * far max_ulp 4 wrong 0 observed\n");
  check_same(folder, 2, audit + "--bounds rows.txt --fail-on wrong_t --write-bounds - ", {"json"});
}

BOOST_AUTO_TEST_CASE(children_of_ranks_are_no_ranks) {
  const Folder folder;
  folder.run(std::string("cp '") + from_environment("mine_c") + "' mine.so");
  check_same(folder, 2, " audit --plugin ./mine.so --cases 2500 --family far,anywhere ", {"json"});
  check_same(folder, 2, " audit --program \"$RAYAUDIT truth\" --shape disk --cases 2500 ",
             {"json"});
  check_same(folder, 2, " audit textbook+fast_math/float --shape disk --cases 2500 ", {"json"});
}

BOOST_AUTO_TEST_CASE(a_mistake_is_told_once) {
  const Folder folder;
  const auto told = [&](const std::string& arguments) {
    const auto ended = by_ranks(folder, 3, arguments);
    BOOST_TEST(ended.code == 2, ended);
    BOOST_TEST(ended.out == "");
    BOOST_TEST(folder.files() == 0);
    return said(ended);
  };
  BOOST_TEST(told(" audit --cases") == folder.run("rayaudit audit --cases").err);
  BOOST_TEST(told(" audit --cases 0") == folder.run("rayaudit audit --cases 0").err);
  BOOST_TEST(told(" audit txtbook/float") == folder.run("rayaudit audit txtbook/float").err);
  BOOST_TEST(told(short_audit + "--report json=/nowhere/a") ==
             folder.run("rayaudit" + short_audit + "--report json=/nowhere/a").err);
  BOOST_TEST(told(" audit --shard 1/2 --report shard=a") ==
             "rayaudit: --shard goes without mpirun, which gives each process a shard\n");
}

BOOST_AUTO_TEST_CASE(a_mistake_of_one_rank_is_told_by_the_first) {
  const Folder folder;
  folder.run(std::string("cp '") + from_environment("mine_c") + "' mine.so");
  const auto missing =
      folder.run(start +
                 "ranks 1 \"$RAYAUDIT\" audit --plugin ./mine.so --report json=a.json : -n 2 "
                 "\"$RAYAUDIT\" audit --plugin ./missing.so --report json=b.json");
  BOOST_TEST(missing.code == 2, missing);
  BOOST_TEST(shell::line_count(said(missing)) == 1, missing);
  BOOST_TEST(contains(said(missing), "rayaudit: rank 1 of 3 on "), missing);
  BOOST_TEST(contains(said(missing), ": plugin `./missing.so` cannot be read: "), missing);
  BOOST_TEST(folder.files() == 1);  // the plugin
  // It would run for days.
  const std::string long_audit = " \"$RAYAUDIT\" audit --cases 1e12 --report json=";
  const auto other =
      folder.run(start + "ranks 1" + long_audit + "a.json : -n 1" + long_audit + "b.json --seed 2");
  BOOST_TEST(other.code == 2, other);
  BOOST_TEST(said(other) ==
             "rayaudit: `rank 1` is no shard of the same run as `rank 0`: its seed is 2, not 1\n");
  BOOST_TEST(folder.files() == 1);
}

BOOST_AUTO_TEST_CASE(a_rank_that_cannot_begin_says_so_and_ends_the_run) {
  const Folder folder;
  folder.run("cp \"$RAYAUDIT\" alone");  // without the module
  const auto ended = folder.run(start + "ranks 1 \"$RAYAUDIT\"" + short_audit +
                                "--report json=a.json : -n 1 ./alone" + short_audit);
  BOOST_TEST(ended.code == 2, ended);
  BOOST_TEST(contains(said(ended), "rayaudit: rank 1 of 2 on "), ended);
  BOOST_TEST(contains(said(ended), " was built without MPI"), ended);
  BOOST_TEST(folder.files() == 1);
}

BOOST_AUTO_TEST_CASE(a_rank_that_fails_ends_the_run_and_leaves_no_report) {
  const Folder folder;
  // Asked before the run, it knows what to say.
  folder.write("mine",
               "if [ \"$SPOILT\" ]; then sed '100,$s/$/ nonsense/;1,99s/$/ miss/'; else sed 's/$/ "
               "miss/'; fi\n");
  const std::string mine = " \"$RAYAUDIT\" audit --program 'bash mine' --shape sphere --cases 1e6 ";
  const auto ended =
      folder.run(start + "ranks 1" + mine + "--report json=a.json : -n 1 env SPOILT=1" + mine +
                 "--report json=a.json");
  BOOST_TEST(ended.code != 0, ended);
  BOOST_TEST(ended.out == "", ended);
  BOOST_TEST(shell::line_count(said(ended)) == 1, ended);
  BOOST_TEST(contains(said(ended), "rayaudit: rank 1 of 2 on "), ended);
  BOOST_TEST(contains(said(ended), "nonsense"), ended);
  BOOST_TEST(contains(said(ended), "; the run ends without a report\n"), ended);
  BOOST_TEST(folder.files() == 1);  // mine
}

BOOST_AUTO_TEST_CASE(a_rank_that_is_killed_ends_the_run_and_leaves_no_report) {
  const Folder folder;
  const auto ended = folder.run(
      start +
      "\"$MPIRUN\" --oversubscribe -n 3 \"$RAYAUDIT\" audit textbook/float --cases 1e9 "
      "--report json=a.json & started=$!\n"
      "until ranks=($(cat /proc/$started/task/*/children)); [ ${#ranks[@]} = 3 ]; do sleep 0.1; "
      "done\n"
      "sleep 3\n"  // they are at work
      "kill -KILL ${ranks[1]}; wait $started; code=$?\n"
      "for rank in ${ranks[@]}; do\n"
      "  for i in {1..100}; do kill -0 $rank 2>/dev/null || continue 2; sleep 0.1; done\n"
      "  echo $rank lives on\n"
      "done\n"
      "exit $code");
  BOOST_TEST(ended.code != 0, ended);
  BOOST_TEST(ended.code != 124, ended);  // of timeout
  BOOST_TEST(ended.out == "");
  BOOST_TEST(contains(ended.err, "signal 9 (Killed)"), ended);
  BOOST_TEST(folder.files() == 0);
}

BOOST_AUTO_TEST_CASE(only_an_audit_is_spread) {
  const Folder folder;
  const auto refused = by_ranks(folder, 2, " list shapes");
  BOOST_TEST(refused.code == 2, refused);
  BOOST_TEST(refused.out == "");
  BOOST_TEST(said(refused) ==
             "rayaudit: mpirun is for `rayaudit audit`: start `rayaudit list` without it\n");
  const auto version = by_ranks(folder, 2, " --version");
  BOOST_TEST((version == folder.run("rayaudit --version")), version);
  BOOST_TEST((by_ranks(folder, 1, " list shapes") == folder.run("rayaudit list shapes")));
}
