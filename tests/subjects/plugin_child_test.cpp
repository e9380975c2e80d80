#include "subjects/plugin_child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <thread>
#include <vector>

#include "geometry/case_line.hpp"
#include "oracle/environment.hpp"
#include "tests/subjects/from_environment.hpp"
#include "tests/subjects/processes.hpp"

using namespace rayaudit;
using namespace std::chrono_literals;

namespace {

constexpr std::size_t sphere = 1;

std::string plugin_path() { return from_environment("misbehaving"); }

Case beginning_at(double x) {
  return read_case_line("sphere 0 0 0 1 ray " + std::to_string(x) + " 0 0 1 0 0").question;
}
const Case easy = beginning_at(-3), hard = beginning_at(13);

/// The planted plugin, in a child of its own.
struct Planted : PluginChild {
  explicit Planted(std::chrono::milliseconds patience = 10s, const std::string& plugin = "")
      : PluginChild(from_environment("RAYAUDIT"), plugin.empty() ? plugin_path() : plugin,
                    patience) {}

  std::vector<Answer> answers(const std::string& subject, const std::vector<Case>& cases) {
    std::vector<Answer> answers(cases.size());
    answer(subject + "/double", sphere, cases, answers);
    return answers;
  }
  /// How asking a subject ends, and what came before that.
  std::pair<Asked, std::vector<Answer>> asked(const std::string& subject,
                                              const std::vector<Case>& cases,
                                              Manner manner = Manner::at_once) {
    std::vector<Answer> answers(cases.size());
    const Asked asked = ask(subject + "/double", sphere, cases, answers, manner);
    answers.resize(asked.answers);
    return {asked, answers};
  }
  /// What comes instead of answers to one case; what did come is shown else.
  std::string excuse(const std::string& subject, const Case& question = hard) {
    try {
      answers(subject, {question});
    } catch (const NoAnswer& why) {
      return why.what();
    }
    return "no excuse: " + case_line(question);
  }
};

std::string excuse_of(const std::string& subject, const std::string& what) {
  return subject + "/double does not answer: its plugin " + plugin_path() + " " + what;
}

const std::vector<Answer> yes(std::size_t count) {
  return std::vector<Answer>(count, Answer::yes());
}

/// Does whoever waits for something look a moment too early, and see nothing?
bool looks_too_early = false;

}  // namespace

/// In place of the system's.
extern "C" int poll(pollfd* sockets, nfds_t count, int milliseconds) {
  const timespec time = {milliseconds / 1000, milliseconds % 1000 * 1'000'000L};
  const int ready = ppoll(sockets, count, milliseconds < 0 ? nullptr : &time, nullptr);
  return looks_too_early && milliseconds > 0 ? 0 : ready;
}

BOOST_AUTO_TEST_CASE(a_plugin_says_what_it_brings) {
  const std::vector<PluginSubject> subjects = Planted().subjects();
  BOOST_TEST_REQUIRE(subjects.size() > 2);
  BOOST_TEST(subjects[0].name == "yes");
  BOOST_TEST(subjects[0].format == "double");
  BOOST_TEST(!subjects[0].answers[0]);
  BOOST_TEST(subjects[0].answers[sphere]);
}

BOOST_AUTO_TEST_CASE(a_plugin_answers_and_its_answers_are_timed) {
  Planted planted;
  const std::vector<Case> cases(5000, easy);
  std::vector<Answer> answers(cases.size());
  const auto start = std::chrono::steady_clock::now();
  const double nanoseconds = planted.answer("yes/double", sphere, cases, answers);
  const std::chrono::duration<double, std::nano> all = std::chrono::steady_clock::now() - start;
  BOOST_TEST((answers == yes(cases.size())));
  BOOST_TEST(nanoseconds > 0);
  BOOST_TEST(nanoseconds < all.count());
  BOOST_TEST(planted.answers("yes", {}).empty());
}

BOOST_AUTO_TEST_CASE(all_answers_are_misses_before_it_is_asked) {
  Planted planted;
  planted.answers("yes", std::vector<Case>(100, easy));
  for (const Manner manner : {Manner::at_once, Manner::one_by_one})
    BOOST_TEST((planted.asked("says_nothing", std::vector<Case>(100, easy), manner).second ==
                std::vector<Answer>(100, Answer::miss())));
}

BOOST_AUTO_TEST_CASE(many_threads_ask_one_child) {
  Planted planted;
  std::vector<std::thread> threads;
  std::atomic<int> right = 0;
  for (std::size_t size : {1, 2, 3, 400})
    threads.emplace_back([&, size] {
      for (int i = 0; i < 50; ++i)
        right += planted.answers("yes", std::vector<Case>(size, easy)) == yes(size);
    });
  for (std::thread& thread : threads) thread.join();
  BOOST_TEST(right == 200);
  BOOST_TEST(children_of(getpid()).size() <= 1);
}

BOOST_AUTO_TEST_CASE(one_by_one_the_answers_before_a_crash_are_there) {
  Planted planted;
  const auto [asked, answers] =
      planted.asked("crashes", {easy, easy, hard, easy}, Manner::one_by_one);
  BOOST_TEST((asked.end == Asked::End::died));
  BOOST_TEST(asked.signal == SIGSEGV);
  BOOST_TEST(asked.sentence == "was killed by SIGSEGV");
  BOOST_TEST((answers == yes(2)));
  BOOST_TEST(planted.asked("crashes", {easy, hard}).first.answers == 0);
}

BOOST_AUTO_TEST_CASE(after_a_crash_it_is_started_anew) {
  Planted planted;
  BOOST_TEST((planted.asked("crashes", {hard}).first.end == Asked::End::died));
  BOOST_TEST((planted.asked("crashes", {easy}).second == yes(1)));
  BOOST_TEST(children_of(getpid()).size() == 1);
}

BOOST_AUTO_TEST_CASE(who_must_have_all_answers_hears_why_there_are_none_and_at_once_again) {
  Planted planted;
  BOOST_TEST(planted.excuse("crashes", easy) == "no excuse: " + case_line(easy));
  BOOST_TEST(planted.excuse("crashes") == excuse_of("crashes", "was killed by SIGSEGV"));
  BOOST_TEST(children_of(getpid()).empty());
  BOOST_TEST(planted.excuse("crashes", easy) == excuse_of("crashes", "was killed by SIGSEGV"));
  BOOST_TEST(children_of(getpid()).empty());
  BOOST_TEST(planted.excuse("yes", easy) == "no excuse: " + case_line(easy));
}

BOOST_AUTO_TEST_CASE(an_end_is_told_by_its_signal_or_its_code) {
  BOOST_TEST(
      Planted().excuse("traps") ==
      excuse_of("traps", "was killed by SIGILL, an instruction that this processor may not have"));
  BOOST_TEST(Planted().excuse("throws") == excuse_of("throws", "was killed by SIGABRT"));
  BOOST_TEST(Planted().excuse("exits") == excuse_of("exits", "ended with exit code 3"));
  Planted planted;
  const auto [asked, answers] = planted.asked("exits", {hard});
  BOOST_TEST((asked.end == Asked::End::died));
  BOOST_TEST(asked.signal == 0);
}

BOOST_AUTO_TEST_CASE(a_child_that_hangs_is_killed_within_its_time) {
  Planted planted(200ms);
  planted.answers("yes", {easy});
  const auto start = std::chrono::steady_clock::now();
  const auto [asked, answers] = planted.asked("hangs", {hard});
  BOOST_TEST((std::chrono::steady_clock::now() - start < 5s));
  BOOST_TEST((asked.end == Asked::End::silent));
  BOOST_TEST(asked.sentence == "said nothing for 0.2 s and was killed");
  BOOST_TEST(children_of(getpid()).empty());
}

BOOST_AUTO_TEST_CASE(what_closes_its_connection_does_not_answer) {
  Planted planted(500ms);
  const auto [asked, answers] = planted.asked("closes", {hard});
  // Its own watch may see it first and end it, or may not.
  BOOST_TEST((asked.end == Asked::End::died || asked.end == Asked::End::silent));
  BOOST_TEST(children_of(getpid()).empty());
}

BOOST_AUTO_TEST_CASE(garbage_on_the_connection_is_told_apart) {
  Planted planted(2s);
  const auto [asked, answers] = planted.asked("garbles", {hard});
  BOOST_TEST((asked.end == Asked::End::garbled));
  BOOST_TEST(asked.sentence == "sent no answers but garbage");
}

BOOST_AUTO_TEST_CASE(an_answer_of_no_known_form_is_garbage_and_the_others_stand) {
  const auto answers = Planted().answers("formless", {easy, hard, easy});
  BOOST_TEST((answers == std::vector{Answer::yes(), Answer::garbage(), Answer::yes()}));
}

BOOST_AUTO_TEST_CASE(what_it_started_ends_with_it_and_does_not_hide_its_end) {
  Planted planted(1s);
  planted.answers("yes", {easy});
  const std::string served = "serve-plugin " + plugin_path();
  const std::size_t before = processes_with(served).size();
  const auto [asked, answers] = planted.asked("leaves_a_child", {hard});
  BOOST_TEST((asked.end == Asked::End::died));
  BOOST_TEST(asked.signal == SIGSEGV);
  BOOST_TEST(comes_true([&] { return processes_with(served).size() < before; }));
}

BOOST_AUTO_TEST_CASE(what_a_plugin_lacks_is_told) {
  BOOST_TEST(Planted().excuse("nobody") == excuse_of("nobody", "does not have it"));
  Planted planted;
  std::vector<Answer> answers(1);
  BOOST_CHECK_THROW(planted.answer("yes/double", 0, {&easy, 1}, answers), NoAnswer);
}

BOOST_AUTO_TEST_CASE(a_plugin_that_cannot_be_loaded_is_told) {
  const auto excuse = [](const std::string& plugin) { return Planted(10s, plugin).excuse("yes"); };
  BOOST_TEST(excuse("/nowhere.so") ==
             "yes/double does not answer: its plugin /nowhere.so cannot be loaded: cannot open "
             "shared object file: No such file or directory");
  BOOST_TEST(excuse("libm.so.6") ==
             "yes/double does not answer: its plugin libm.so.6 is no plugin: it lacks the symbol "
             "rayaudit_plugin_entry, which the macro RAYAUDIT_PLUGIN of rayaudit/plugin.h defines");
}

BOOST_AUTO_TEST_CASE(what_a_child_says_just_before_its_end_is_heard) {
  std::string folder = (std::filesystem::temp_directory_path() / "rayaudit-XXXXXX").string();
  BOOST_TEST_REQUIRE(mkdtemp(folder.data()) != nullptr);
  const std::string why = "says why, and ends", program = folder + "/program";
  const PluginReply reply = {.refused = 1, .bytes = why.size()};
  std::ofstream(folder + "/words").write(reinterpret_cast<const char*>(&reply), sizeof reply)
      << why;
  std::ofstream(program) << "#!/bin/sh\ncat '" << folder << "/words' >&0\n";
  chmod(program.c_str(), 0700);
  looks_too_early = true;
  std::string heard = "nothing";
  try {
    PluginChild(program, "none.so", 10s).subjects();
  } catch (const PluginChild::Unloaded& refusal) {
    heard = refusal.sentence;
  }
  looks_too_early = false;
  std::filesystem::remove_all(folder);
  BOOST_TEST(heard == why);
}

BOOST_AUTO_TEST_CASE(a_program_that_cannot_be_run_is_told) {
  PluginChild child("/nowhere", plugin_path(), 10s);
  std::vector<Answer> answers(1);
  BOOST_CHECK_EXCEPTION(
      child.answer("yes/double", sphere, {&easy, 1}, answers), NoAnswer, [](const NoAnswer& why) {
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
  // Three of its own, and the connection.
  BOOST_TEST((Planted().answers("descriptors", {easy}) == std::vector{Answer::hit(real(4.0))}));
  close(ours);
}

BOOST_AUTO_TEST_CASE(what_a_plugin_prints_reaches_neither_us_nor_our_output) {
  std::FILE* const output = std::tmpfile();
  const int stdout_before = dup(STDOUT_FILENO);
  dup2(fileno(output), STDOUT_FILENO);
  Planted planted;
  const std::vector<Answer> answers = planted.answers("prints", {easy, easy});
  dup2(stdout_before, STDOUT_FILENO);
  BOOST_TEST((answers == yes(2)));
  BOOST_TEST(lseek(fileno(output), 0, SEEK_END) == 0);
  std::fclose(output);
}

BOOST_AUTO_TEST_CASE(a_plugin_that_reads_standard_input_finds_nothing_there) {
  Planted planted(2s);
  BOOST_TEST((planted.answers("reads", {easy}) == yes(1)));
  BOOST_TEST((planted.answers("yes", {easy}) == yes(1)));
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
