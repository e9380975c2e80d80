#include "subjects/program.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <cctype>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

#include "geometry/case_line.hpp"
#include "geometry/error.hpp"

using namespace rayaudit;
using namespace std::chrono_literals;

namespace {

constexpr std::size_t sphere = 1;
constexpr auto miss = "sed 's/$/ miss/'";

/// Spheres, the origin of each at another x: 1, 2, 3 and so on.
std::vector<Case> cases(std::size_t count) {
  std::vector<Case> all(count, read_case_line("sphere 0 0 0 1 ray 0 0 -3 0 0 1").question);
  for (std::size_t i = 0; i < count; ++i) all[i].ray.origin.x = static_cast<double>(i + 1);
  return all;
}

std::vector<Answer> answers(const Subject& subject, const std::vector<Case>& asked) {
  std::vector<Answer> said(asked.size(), Answer::garbage());
  subject.answer[sphere](asked, said);
  return said;
}
std::vector<Answer> answers(const std::string& command, const std::vector<Case>& asked,
                            std::chrono::milliseconds patience = 10s) {
  return answers(program_subject(command, double_format, patience), asked);
}

/// What the program does in place of answers, as the sentence about it goes on.
std::string excuse(const std::string& command, std::size_t count = 10,
                   std::chrono::milliseconds patience = 10s) {
  try {
    answers(command, cases(count), patience);
  } catch (const NoAnswer& why) {
    const std::string sentence = why.what();
    const std::string begin = program_subject(command, double_format).name +
                              " does not answer: its program `" + command.substr(0, 60) +
                              (command.size() > 60 ? "..." : "") + "` ";
    return sentence.starts_with(begin) ? sentence.substr(begin.size()) : "not so: " + sentence;
  }
  return "no excuse";
}

/// Commands that do something when they read the case of x = 7, and else say miss: line by line, or
/// all at the end.
std::string at_seven(const std::string& action) {
  return "while read -r l; do case \"$l\" in *' ray 0x1.cp+2 '*) " + action +
         ";; esac; echo \"$l miss\"; done";
}
std::string at_seven_all_at_once(const std::string& action) {
  return "t=$(sed 's/$/ miss/'); case \"$t\" in *' ray 0x1.cp+2 '*) " + action +
         ";; esac; echo \"$t\"";
}

/// Are all of them misses, but for that of one x?
bool are_misses_but(std::size_t x, const std::vector<Answer>& said) {
  for (std::size_t i = 0; i < said.size(); ++i)
    if (i + 1 != x && said[i] != Answer::miss()) return false;
  return true;
}

/// The processes of a group, those that only wait for somebody to hear of their end left out.
std::size_t members_of(pid_t group) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    if (std::isdigit(entry.path().filename().string()[0]) == 0) continue;
    std::ifstream stat(entry.path() / "stat");
    std::string text;
    std::getline(stat, text);
    const std::size_t name_end = text.rfind(')');
    if (name_end == text.npos) continue;
    char state = 0;
    int parent = 0, its_group = 0;
    std::sscanf(text.c_str() + name_end + 1, " %c %d %d", &state, &parent, &its_group);
    count += its_group == group && state != 'Z' && state != 'X';
  }
  return count;
}

template <class Condition>
bool comes_true(const Condition& condition) {
  for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(10ms);
  return condition();
}

/// A file that a program writes what we are to see.
class Note {
 public:
  Note() { close(mkstemp(path_.data())); }
  ~Note() { unlink(path_.c_str()); }
  const std::string& path() const { return path_; }
  std::vector<std::string> words() const {
    std::ifstream file(path_);
    return {std::istream_iterator<std::string>(file), {}};
  }

 private:
  std::string path_ = (std::filesystem::temp_directory_path() / "rayaudit-XXXXXX").string();
};

std::string to(const Note& note) { return " >" + note.path(); }

}  // namespace

BOOST_AUTO_TEST_CASE(a_program_is_a_subject_elsewhere_named_by_its_command) {
  const Subject subject = program_subject(" ./bin/mine --flag", float_format);
  BOOST_TEST(subject.name == "mine/float");
  BOOST_TEST((subject.format == float_format));
  BOOST_TEST(subject.is_elsewhere);
  for (std::size_t shape = 0; shape < shape_count; ++shape) BOOST_TEST(subject.answers(shape));
}

BOOST_AUTO_TEST_CASE(the_name_of_a_program_is_a_plain_word_whatever_its_command) {
  const auto name = [](const std::string& command) {
    return program_subject(command, double_format).name;
  };
  BOOST_TEST(name("THREADS=1 ./mine --flag") == "mine/double");
  BOOST_TEST(name(" A=1\tB_2='two words' C=\"it's\" bin/mine -x=1") == "mine/double");
  BOOST_TEST(name("./a=b/mine") == "mine/double");
  BOOST_TEST(name("\"$HOME/my tools/mine\" --flag") == "mine/double");
  BOOST_TEST(name("'my mine*'") == "my_mine_/double");
  BOOST_TEST(name("mine-2.0+x;true") == "mine-2.0+x_true/double");
  BOOST_TEST(name("A=1 textbook") == "./textbook/double");
  for (const char* nameless : {"A=1", "./", "'", "[ 1 ]", "\"\" x"})
    BOOST_TEST(name(nameless) == "program/double", nameless);
}

BOOST_AUTO_TEST_CASE(a_program_does_not_pass_for_one_of_ours) {
  BOOST_TEST(program_subject("textbook --fast", double_format).name == "./textbook/double");
  BOOST_TEST(program_subject("bin/handout", float_format).name == "./handout/float");
}

BOOST_AUTO_TEST_CASE(answers_come_back_behind_their_cases) {
  const std::string mixed =
      "sed '1~4s/$/ hit 2.5/; 2~4s/$/ at 0 1 -2/; 3~4s/$/ yes/; 4~4s/$/ miss/'";
  const std::vector<Answer> said = answers(mixed, cases(5));
  BOOST_TEST(
      (said == std::vector{Answer::hit(real(2.5)), Answer::at({real(0.0), real(1.0), real(-2.0)}),
                           Answer::yes(), Answer::miss(), Answer::hit(real(2.5))}));
}

BOOST_AUTO_TEST_CASE(a_whole_batch_passes_both_ways_at_once_or_one_after_the_other) {
  const std::vector<Case> many = cases(batch_elsewhere);
  for (const std::string& command :
       {std::string(miss), "t=$(" + std::string(miss) + "); echo \"$t\""})
    BOOST_TEST(are_misses_but(0, answers(command, many)), command);
}

BOOST_AUTO_TEST_CASE(every_kind_of_number_comes_back_as_the_same_case) {
  const double inf = std::numeric_limits<double>::infinity();
  std::vector<Case> odd = cases(3);
  odd[0].ray.origin = {std::nan(""), -0.0, inf};
  odd[1].ray.direction = {-inf, 0x1p-1074, 0x1.fffffffffffffp1023};
  odd[2].ray.t_min = -inf, odd[2].ray.t_max = 1;
  BOOST_TEST(are_misses_but(0, answers(miss, odd)));
  BOOST_TEST(are_misses_but(0, answers("sed 's/-0x0p+0/0/; s/$/ miss/'", odd)));
}

BOOST_AUTO_TEST_CASE(any_spelling_will_do_and_comments_blank_lines_and_a_missing_last_end) {
  const auto are_read = [](const std::string& command) {
    return are_misses_but(0, answers(command, cases(9)));
  };
  BOOST_TEST(are_read("sed 's/0x1p+0/1.0/g; s/0x1.4p+2/5e0/; s/ /\\t /g; s/$/  miss/'"));
  BOOST_TEST(are_read("sed 's/$/ miss # for sure\\n\\n  # more/; 1i# begin'"));
  BOOST_TEST(are_read("sed 's/$/ miss\\r/'"));
  BOOST_TEST(are_read("printf %s \"$(sed 's/$/ miss/')\""));
}

BOOST_AUTO_TEST_CASE(a_command_that_cannot_be_started_is_the_users_mistake) {
  const auto mistake = [](const std::string& command) -> std::string {
    try {
      answers("exec 2>/dev/null; " + command, {});
    } catch (const Error& why) {
      return why.what();
    }
    return "none";
  };
  BOOST_TEST(
      mistake("/nowhere/mine") ==
      "program `exec 2>/dev/null; /nowhere/mine` cannot be started: there is no such command "
      "(exit code 127 of the shell)");
  BOOST_TEST(mistake("/tmp").find("cannot be started: it is nothing that can be run (exit code "
                                  "126 of the shell)") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_program_that_fails_at_the_easiest_case_is_told_with_it) {
  const std::string easy = " when asked `sphere 0 0 0 1 ray 0.25 0.25 -3 0 0 1`";
  BOOST_TEST(excuse("exit 3") == "ended with exit code 3 after 0 of 1 answers" + easy);
  BOOST_TEST(excuse("kill -SEGV $$") == "was killed by SIGSEGV after 0 of 1 answers" + easy);
  BOOST_TEST(excuse("exit 134") == "was killed by SIGABRT after 0 of 1 answers" + easy);
  BOOST_TEST(excuse("cat >/dev/null; sleep 1000", 1, 200ms) ==
             "said nothing for 0.2 s after 0 of 1 answers" + easy);
  BOOST_TEST(excuse("true") ==
             "ended after 0 of 1 answers; there is none to `sphere 0x0p+0 0x0p+0 0x0p+0 0x1p+0 ray "
             "0x1p-2 0x1p-2 -0x1.8p+1 0x0p+0 0x0p+0 0x1p+0`");
}

BOOST_AUTO_TEST_CASE(an_empty_batch_tries_out_a_shape_once) {
  const Note note;
  const Subject subject = program_subject("echo run >>" + note.path() + "; " + miss, double_format);
  answers(subject, {});
  answers(subject, {});
  BOOST_TEST(note.words().size() == 1u);
  subject.answer[0]({}, {});
  BOOST_TEST(note.words().size() == 2u);
  BOOST_TEST(are_misses_but(0, answers(subject, cases(5))));
  BOOST_TEST(note.words().size() == 3u);
}

BOOST_AUTO_TEST_CASE(a_line_that_is_no_answer_is_told_by_its_number_and_its_words) {
  const std::string quoted = "`sphere 0x0p+0 0x0p+0 0x0p+0 0x1p+0 ray ";
  BOOST_TEST(excuse("cat") == "printed, as line 1, " + quoted +
                                  "0x1p-2 0x1p-2 -0x1.8p...`: there is no answer after the case");
  BOOST_TEST(excuse("echo; echo Hello") ==
             "printed, as line 2, `Hello`: shape `Hello` is not known; known are `disk`, `sphere`, "
             "`cylinder`, `cone`, `capped_cylinder`, `capped_cone`");
  BOOST_TEST(excuse("sed '3s/$/ hit/; 3!s/$/ miss/'") ==
             "printed, as line 3, " + quoted +
                 "0x1.8p+1 0x0p+0 -0x1....`: hit: expected t, got the end of the line");
  BOOST_TEST(excuse("sed 's/$/ miss/; 4s/.*/\\x1b[31m/'") ==
             "printed, as line 4, `\\x1b[31m`: shape `\\x1b[31m` is not known; known are `disk`, "
             "`sphere`, `cylinder`, `cone`, `capped_cylinder`, `capped_cone`");
}

BOOST_AUTO_TEST_CASE(a_case_that_does_not_come_back_in_its_turn_is_told) {
  const auto turn = [](const std::string& command) {
    const std::string told = excuse(command);
    return told.substr(0, 20) + "|" + told.substr(std::min(told.size(), told.find("`: ") + 3));
  };
  const std::string line = "printed, as line ";
  BOOST_TEST(turn("sed 's/$/ miss/; 3p'") ==
             line + "4, |that is case 3 of 10 where it is the turn of case 4");
  BOOST_TEST(turn("sed 's/$/ miss/; 3d'") ==
             line + "3, |that is case 4 of 10 where it is the turn of case 3");
  BOOST_TEST(turn("sed 's/$/ miss/' | tac") ==
             line + "1, |that is case 10 of 10 where it is the turn of case 1");
  BOOST_TEST(turn("sed 's/$/ miss/; 10p'") ==
             line + "11,|10 answers were asked for, this is one more");
  BOOST_TEST(turn("sed 's/$/ miss/; s/ray 0x1.8p+1 /ray 3.0001 /'") ==
             line +
                 "3, |case 3 should come back as it was asked, but its number 5 came back as "
                 "0x1.800346dc5d639p+1, not 0x1.8p+1");
  BOOST_TEST(turn("sed 's/$/ miss/; 3s/$/./; s/ miss./ range 1 2 miss/'") ==
             line +
                 "3, |case 3 should come back as it was asked, but its number 11 came back as "
                 "0x1p+0, not 0x0p+0");
  BOOST_TEST(turn("sed '2s/sphere\\( [^ ]*\\)/disk 0 0\\1 0/; s/$/ miss/'") ==
             line + "2, |case 2 should come back as it was asked, but this has another shape");
}

BOOST_AUTO_TEST_CASE(a_program_that_ends_early_or_badly_is_told) {
  BOOST_TEST(excuse("head -n 3 | sed 's/$/ miss/'") ==
             "ended after 3 of 10 answers; there is none to `" + case_line(cases(4).back()) + "`");
  BOOST_TEST(excuse("sed 's/$/ miss/'; exit 3") == "ended with exit code 3 after 1 of 1 answers");
  BOOST_TEST(excuse("sed 's/$/ miss/'; kill -TERM $$") ==
             "was killed by SIGTERM after 1 of 1 answers");
}

BOOST_AUTO_TEST_CASE(a_program_that_closes_its_input_does_not_take_us_along) {
  const auto before = std::signal(SIGPIPE, SIG_DFL);  // whoever started us may have it ignored
  BOOST_TEST(excuse("read -r l; exec <&-; sleep 0.1; echo \"$l miss\"", batch_elsewhere)
                 .starts_with("ended after 1 of 16384 answers; there is none to `"));
  std::signal(SIGPIPE, before);
}

BOOST_AUTO_TEST_CASE(output_without_end_is_cut_off) {
  BOOST_TEST(excuse("yes").starts_with("printed, as line 1, `y`: "));
  BOOST_TEST(excuse("tr '\\0' x </dev/zero") ==
             "printed, as line 1, `" + std::string(60, 'x') + "...`: it does not end");
  BOOST_TEST(excuse("yes '#'") == "printed over 100000 lines that are blank or comments");
}

BOOST_AUTO_TEST_CASE(a_program_that_does_not_end_after_its_answers_is_told) {
  const std::string told = "did not end within 0.2 s after 1 of 1 answers";
  BOOST_TEST(excuse("sed 's/$/ miss/'; sleep 1000", 1, 200ms) == told);
  BOOST_TEST(excuse("sed 's/$/ miss/'; exec >&-; sleep 1000", 1, 200ms) == told);
}

BOOST_AUTO_TEST_CASE(patience_counts_from_the_last_progress) {
  BOOST_TEST(are_misses_but(
      0, answers("while read -r l; do sleep 0.2; echo \"$l miss\"; done", cases(5), 900ms)));
}

BOOST_AUTO_TEST_CASE(the_case_that_a_program_dies_of_is_found) {
  for (const std::string& command :
       {at_seven("kill -SEGV $$"), at_seven_all_at_once("kill -SEGV $$"),
        at_seven_all_at_once("exit 139")}) {
    const std::vector<Answer> said = answers(command, cases(1000));
    BOOST_TEST((said[6] == Answer::crashed(SIGSEGV)), command);
    BOOST_TEST(int{said[6].signal} == SIGSEGV);
    BOOST_TEST(are_misses_but(7, said), command);
  }
  const std::vector<Answer> said = answers(at_seven_all_at_once("exit 3"), cases(50));
  BOOST_TEST((said[6] == Answer::crashed(0)));
  BOOST_TEST(int{said[6].signal} == 0);
  BOOST_TEST(are_misses_but(7, said));
  const std::vector<Case> alone = {cases(7).back()};
  BOOST_TEST((answers(at_seven("exit 3"), alone) == std::vector{Answer::crashed(0)}));
}

BOOST_AUTO_TEST_CASE(the_case_that_a_program_hangs_over_is_found) {
  for (const std::string& command : {at_seven("sleep 1000"), at_seven_all_at_once("sleep 1000")}) {
    const std::vector<Answer> said = answers(command, cases(100), 400ms);
    BOOST_TEST((said[6] == Answer::timed_out()), command);
    BOOST_TEST(are_misses_but(7, said), command);
  }
}

BOOST_AUTO_TEST_CASE(four_cases_of_a_batch_are_found_and_the_rest_is_unasked) {
  const std::vector<Answer> said = answers(
      "while read -r l; do case \"$l\" in *'ray 0x1p-2 '*) ;; *p+4*) kill -SEGV $$;; "
      "esac; echo \"$l miss\"; done",
      cases(100));
  std::vector<Answer> told(100, Answer::unasked());  // x = 16 is the first that has p+4
  std::fill_n(told.begin(), 15, Answer::miss());
  std::fill_n(told.begin() + 15, 4, Answer::crashed(SIGSEGV));
  BOOST_TEST((said == told));
}

BOOST_AUTO_TEST_CASE(a_program_that_never_reads_costs_a_bounded_time) {
  const std::string command =
      "read -r l; case \"$l\" in *'ray 0x1p-2 '*) echo \"$l miss\";; *) sleep 1000;; esac";
  const Subject subject = program_subject(command, double_format, 80ms);
  for (int i = 0; i < 2; ++i) {
    const std::vector<Answer> said = answers(subject, cases(batch_elsewhere));
    BOOST_TEST((said.back() == Answer::unasked()));
    BOOST_TEST((said.front() == (i == 0 ? Answer::timed_out() : Answer::unasked())));
  }
  BOOST_TEST((answers(subject, cases(1)) == std::vector{Answer::timed_out()}));
}

BOOST_AUTO_TEST_CASE(a_program_that_dies_only_over_many_cases_has_died_over_one_of_them) {
  const std::vector<Answer> said =
      answers("awk 'NR == 100 { exit 5 } { print $0 \" miss\" }'", cases(150));
  BOOST_TEST(std::count(said.begin(), said.end(), Answer::crashed(0)) == 1);
  BOOST_TEST(std::count(said.begin(), said.end(), Answer::miss()) == 149);
}

BOOST_AUTO_TEST_CASE(a_program_that_is_only_slow_over_many_cases_answers_them_all) {
  const std::string command =
      "t=$(sed 's/$/ miss/'); [ ${#t} -lt 9000 ] || sleep 1000; echo \"$t\"";
  BOOST_TEST(are_misses_but(0, answers(command, cases(150), 600ms)));
}

BOOST_AUTO_TEST_CASE(many_threads_ask_one_program) {
  const Subject subject = program_subject(miss, double_format);
  std::vector<std::thread> threads;
  std::atomic<int> right = 0;
  for (const std::size_t size : {1, 20, 300})
    threads.emplace_back([&, size] {
      for (int i = 0; i < 5; ++i) right += are_misses_but(0, answers(subject, cases(size)));
    });
  for (std::thread& thread : threads) thread.join();
  BOOST_TEST(right == 15);
}

BOOST_AUTO_TEST_CASE(a_program_has_none_of_our_descriptors_and_no_children_but_its_own) {
  const int ours = dup2(STDERR_FILENO, 50);  // as others leave them: not closed on exec
  const Note descriptors, children;
  answers("ls /proc/self/fd" + to(descriptors) + "; cat /proc/$$/task/$$/children" + to(children) +
              "; " + miss,
          {});
  close(ours);
  BOOST_TEST(descriptors.words() == (std::vector<std::string>{"0", "1", "2", "3"}),
             boost::test_tools::per_element());  // 3 is the folder
  BOOST_TEST(children.words().size() == 1u);     // that is cat
}

BOOST_AUTO_TEST_CASE(nothing_that_a_program_started_outlives_its_answers) {
  const Note note;
  const std::string background = "echo $$" + to(note) + "; sleep 1000 >/dev/null & ";
  for (const std::string end : {miss, "cat", "sleep 1000", "kill -KILL $$", "exit 3"}) {
    try {
      answers(background + end, {}, 300ms);
    } catch (const NoAnswer&) {  // of some
    }
    BOOST_TEST_REQUIRE(note.words().size() == 1u);
    BOOST_TEST(members_of(std::stoi(note.words()[0])) == 0u, end);
  }
}

BOOST_AUTO_TEST_CASE(a_program_that_heeds_nothing_ends_when_we_are_killed) {
  const Note note;
  const pid_t ours = fork();
  if (ours == 0) {
    answers("trap '' HUP INT PIPE TERM; echo $$" + to(note) +
                "; sleep 1000 </dev/null >/dev/null & sleep 1000",
            {}, 100s);
    _exit(0);
  }
  BOOST_TEST_REQUIRE(comes_true([&] { return note.words().size() == 1; }));
  const pid_t group = std::stoi(note.words()[0]);
  // The program, its sleep and the watcher, at the least.
  BOOST_TEST(comes_true([&] { return members_of(group) >= 3; }));
  kill(ours, SIGKILL);
  waitpid(ours, nullptr, 0);
  BOOST_TEST(comes_true([&] { return members_of(group) == 0; }));
}
