#define BOOST_TEST_MODULE module_child
#include "subjects/module_child.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <csignal>
#include <fstream>
#include <iterator>
#include <optional>
#include <thread>
#include <vector>

#include "geometry/case_line.hpp"
#include "oracle/environment.hpp"
#include "tests/subjects/from_environment.hpp"

using namespace rayaudit;
using namespace std::chrono_literals;

namespace {

constexpr std::size_t sphere = 1;

std::string module_path() { return from_environment("misbehaving"); }

/// The planted module, in a child of its own.
struct Planted : ModuleChild {
  explicit Planted(std::chrono::milliseconds patience = 10s, const std::string& module = "")
      : ModuleChild(from_environment("RAYAUDIT"), module.empty() ? module_path() : module,
                    patience) {}

  std::vector<Answer> answers(const std::string& subject, const std::vector<Case>& cases) {
    std::vector<Answer> answers(cases.size());
    answer(subject, sphere, cases, answers);
    return answers;
  }
  /// What comes instead of answers to one case with this origin; what did come is shown else.
  std::string excuse(const std::string& subject, int x = 0) {
    const std::string line = "sphere 0 0 0 1 ray " + std::to_string(x) + " 0 0 1 0 0";
    try {
      answers(subject, {read_case_line(line).question});
    } catch (const NoAnswer& why) {
      return why.what();
    }
    return "no excuse: " + line;
  }
};

const Case easy = read_case_line("sphere 0 0 0 1 ray -3 0 0 1 0 0").question;

std::string excuse_of(const std::string& subject, const std::string& what) {
  return subject + " does not answer: its module " + module_path() + " " + what;
}

/// The children of the first thread of a process.
std::vector<pid_t> children_of(pid_t parent) {
  const std::string id = std::to_string(parent);
  std::ifstream list("/proc/" + id + "/task/" + id + "/children");
  return {std::istream_iterator<pid_t>(list), {}};
}

/// Is it there, and not only waiting for somebody to hear of its end?
bool lives(pid_t child) {
  std::ifstream stat("/proc/" + std::to_string(child) + "/stat");
  std::string id, name, state;
  return stat >> id >> name >> state && state != "Z" && state != "X";
}

template <class Condition>
bool comes_true(const Condition& condition) {
  for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(10ms);
  return condition();
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_module_answers_and_its_answers_are_timed) {
  Planted planted;
  const std::vector<Case> cases(5000, easy);
  std::vector<Answer> answers(cases.size());
  const auto start = std::chrono::steady_clock::now();
  const double nanoseconds = planted.answer("yes", sphere, cases, answers);
  const std::chrono::duration<double, std::nano> all = std::chrono::steady_clock::now() - start;
  BOOST_TEST((answers == std::vector<Answer>(cases.size(), Answer::yes())));
  BOOST_TEST(nanoseconds > 0);
  BOOST_TEST(nanoseconds < all.count());
  BOOST_TEST(planted.answers("yes", {}).empty());
}

BOOST_AUTO_TEST_CASE(many_threads_ask_one_child) {
  Planted planted;
  std::vector<std::thread> threads;
  std::atomic<int> right = 0;
  for (std::size_t size : {1, 2, 3, 400})
    threads.emplace_back([&, size] {
      for (int i = 0; i < 50; ++i)
        right += planted.answers("yes", std::vector<Case>(size, easy)) ==
                 std::vector<Answer>(size, Answer::yes());
    });
  for (std::thread& thread : threads) thread.join();
  BOOST_TEST(right == 200);
  BOOST_TEST(children_of(getpid()).size() <= 1);
}

BOOST_AUTO_TEST_CASE(a_crash_is_told_by_its_signal_and_its_subject_and_there_is_no_second_child) {
  Planted planted;
  BOOST_TEST(planted.excuse("crashes", 12) == "no excuse: sphere 0 0 0 1 ray 12 0 0 1 0 0");
  BOOST_TEST(planted.excuse("crashes", 13) == excuse_of("crashes", "was killed by SIGSEGV"));
  BOOST_TEST(planted.excuse("crashes", 12) == excuse_of("crashes", "was killed by SIGSEGV"));
  BOOST_TEST(planted.excuse("yes") ==
             excuse_of("yes", "was killed by SIGSEGV when crashes was asked"));
  BOOST_TEST(children_of(getpid()).empty());
}

BOOST_AUTO_TEST_CASE(an_unknown_instruction_is_told_as_such) {
  BOOST_TEST(
      Planted().excuse("traps") ==
      excuse_of("traps", "was killed by SIGILL, an instruction that this processor may not have"));
}

BOOST_AUTO_TEST_CASE(an_exit_is_told_by_its_code) {
  BOOST_TEST(Planted().excuse("exits") == excuse_of("exits", "ended with exit code 3"));
}

BOOST_AUTO_TEST_CASE(a_child_that_hangs_is_killed_within_its_time) {
  Planted planted(200ms);
  planted.answers("yes", {easy});
  const auto start = std::chrono::steady_clock::now();
  const std::string excuse = planted.excuse("hangs");
  BOOST_TEST((std::chrono::steady_clock::now() - start < 5s));
  BOOST_TEST(excuse == excuse_of("hangs", "said nothing for 0.2 s and was killed"));
  BOOST_TEST(children_of(getpid()).empty());
}

BOOST_AUTO_TEST_CASE(garbage_is_no_answer) {
  BOOST_TEST(Planted().excuse("garbles") == excuse_of("garbles", "sent no answers but garbage"));
  BOOST_TEST(Planted().excuse("formless") ==
             excuse_of("formless", "sent an answer of no known form"));
}

BOOST_AUTO_TEST_CASE(what_a_module_lacks_is_told) {
  BOOST_TEST(Planted().excuse("nobody") == excuse_of("nobody", "does not have it"));
  Planted planted;
  std::vector<Answer> answers(1);
  BOOST_CHECK_THROW(planted.answer("yes", 0, {&easy, 1}, answers), NoAnswer);
}

BOOST_AUTO_TEST_CASE(a_module_that_cannot_be_loaded_is_told) {
  const auto excuse = [](const std::string& module) { return Planted(10s, module).excuse("yes"); };
  BOOST_TEST(excuse("/nowhere.so")
                 .find("yes does not answer: its module /nowhere.so cannot be loaded: ") == 0);
  BOOST_TEST(excuse("libm.so.6") ==
             "yes does not answer: its module libm.so.6 is not one of rayaudit's: it lacks the "
             "symbol rayaudit_module");
  const std::string other = from_environment("another_version");
  BOOST_TEST(excuse(other) == "yes does not answer: its module " + other +
                                  " is of another version of rayaudit: build both anew");
}

BOOST_AUTO_TEST_CASE(a_program_that_cannot_be_run_is_told) {
  ModuleChild child("/nowhere", module_path());
  std::vector<Answer> answers(1);
  BOOST_CHECK_EXCEPTION(
      child.answer("yes", sphere, {&easy, 1}, answers), NoAnswer, [](const NoAnswer& why) {
        return why.what() ==
               excuse_of("yes", "is left without a process: /nowhere: No such file or directory");
      });
}

BOOST_AUTO_TEST_CASE(a_child_killed_between_two_batches_does_not_take_us_along) {
  Planted planted;
  planted.answers("yes", {easy});
  const std::vector<pid_t> children = children_of(getpid());
  BOOST_TEST_REQUIRE(children.size() == 1);
  std::signal(SIGPIPE, SIG_DFL);  // whoever started us may have it ignored
  kill(children[0], SIGKILL);
  BOOST_TEST_REQUIRE(comes_true([&] { return !lives(children[0]); }));
  BOOST_TEST(planted.excuse("yes") == excuse_of("yes", "was killed by SIGKILL"));
}

BOOST_AUTO_TEST_CASE(the_child_has_none_of_our_descriptors) {
  const int ours = open("/dev/null", O_RDONLY);  // as others leave them: not closed on exec
  Planted other;
  other.answers("yes", {easy});
  BOOST_TEST((Planted().answers("descriptors", {easy}) == std::vector{Answer::hit(real(3.0))}));
  close(ours);
}

BOOST_AUTO_TEST_CASE(what_a_module_prints_reaches_neither_us_nor_our_output) {
  std::FILE* const output = std::tmpfile();
  const int stdout_before = dup(STDOUT_FILENO);
  dup2(fileno(output), STDOUT_FILENO);
  Planted planted;
  const std::vector<Answer> answers = planted.answers("prints", {easy, easy});
  dup2(stdout_before, STDOUT_FILENO);
  BOOST_TEST((answers == std::vector<Answer>(2, Answer::yes())));
  BOOST_TEST(lseek(fileno(output), 0, SEEK_END) == 0);
  std::fclose(output);
}

BOOST_AUTO_TEST_CASE(the_arithmetic_of_the_child_is_its_own) {
  Planted planted;
  planted.answers("flushes", {easy});
  BOOST_CHECK_NO_THROW(oracle::require_plain_arithmetic());
}

BOOST_AUTO_TEST_CASE(a_child_ends_with_its_owner) {
  auto planted = std::make_optional<Planted>();
  planted->answers("yes", {easy});
  const std::vector<pid_t> children = children_of(getpid());
  BOOST_TEST_REQUIRE(children.size() == 1);
  planted.reset();
  BOOST_TEST(!lives(children[0]));
}

BOOST_AUTO_TEST_CASE(a_child_that_hangs_ends_when_the_program_is_killed) {
  const pid_t program = fork();
  if (program == 0) {
    Planted(100s).excuse("hangs");
    _exit(0);
  }
  const auto asked = [&] { return children_of(program).size() == 1; };
  BOOST_TEST_REQUIRE(comes_true(asked));
  const pid_t child = children_of(program)[0];
  std::this_thread::sleep_for(300ms);  // it may still be on its way to hang
  BOOST_TEST(lives(child));
  kill(program, SIGKILL);
  waitpid(program, nullptr, 0);
  BOOST_TEST(comes_true([&] { return !lives(child); }));
}
