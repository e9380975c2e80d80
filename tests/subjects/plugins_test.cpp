#include "subjects/plugins.hpp"

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <set>

#include "geometry/case_line.hpp"
#include "geometry/error.hpp"
#include "tests/subjects/from_environment.hpp"
#include "tests/subjects/processes.hpp"

using namespace rayaudit;
using namespace std::chrono_literals;

namespace {

std::vector<Subject> subjects_of(const std::string& plugin,
                                 std::chrono::milliseconds patience = 2s) {
  return plugin_subjects(from_environment(plugin.c_str()), patience, from_environment("RAYAUDIT"));
}

/// What is said of the planted plugin with this flaw, after its name.
std::string refusal_of(const std::string& flaw) {
  setenv("FLAW", flaw.c_str(), 1);
  const std::string start = "plugin `" + from_environment("mistaken") + "` ";
  std::string sentence = "it is taken";
  try {
    subjects_of("mistaken");
  } catch (const Error& why) {
    sentence = why.what();
    BOOST_TEST(sentence.starts_with(start), sentence);
    sentence.erase(0, start.size());
  }
  unsetenv("FLAW");
  return sentence;
}

const Subject& named(const std::vector<Subject>& subjects, const std::string& name) {
  for (const Subject& subject : subjects)
    if (subject.name == name) return subject;
  throw std::runtime_error(name + " is not there");
}

const Case easy = read_case_line("sphere 0 0 0 1 ray -3 0 0 1 0 0").question;
const Case hard = read_case_line("sphere 0 0 0 1 ray 13 0 0 1 0 0").question;

}  // namespace

BOOST_AUTO_TEST_CASE(a_plugin_brings_its_subjects_with_format_shapes_and_convention) {
  const std::vector<Subject> mine = subjects_of("mine_cpp");
  BOOST_TEST_REQUIRE(mine.size() == 1);
  BOOST_TEST(mine[0].name == "mine/float");
  BOOST_TEST((mine[0].format == float_format));
  BOOST_TEST(mine[0].answers(0));
  BOOST_TEST(!mine[0].answers(1));
  BOOST_TEST(mine[0].is_elsewhere);
  Convention rim;
  rim.of(oracle::Kind::rim) = Convention::Stance::hit;
  BOOST_TEST((mine[0].convention == rim));
}

BOOST_AUTO_TEST_CASE(its_subjects_answer) {
  const std::vector<Subject> mine = subjects_of("mine_c");
  BOOST_TEST((answer_one(mine[0], easy) == Answer::hit(real(2.0))));
  Answer said;
  BOOST_TEST(mine[0].timed[1]({&easy, 1}, {&said, 1}) > 0);
  BOOST_TEST((said == Answer::hit(real(2.0))));
}

BOOST_AUTO_TEST_CASE(each_subject_has_a_process_of_its_own) {
  const std::vector<Subject> all = subjects_of("misbehaving");
  const std::vector<Subject> again = subjects_of("misbehaving");
  std::set<double> processes = {static_cast<double>(getpid())};
  for (const auto* subjects : {&all, &again})
    processes.insert(answer_one(named(*subjects, "process/double"), easy).t.high);
  BOOST_TEST(processes.size() == 3);
  answer_one(named(all, "crashes/double"), hard);
  BOOST_TEST(processes.contains(answer_one(named(all, "process/double"), easy).t.high));
}

BOOST_AUTO_TEST_CASE(a_crash_and_a_hang_are_answers) {
  const std::vector<Subject> all = subjects_of("misbehaving", 500ms);
  const auto said = [&](const std::string& name) {
    std::vector<Answer> answers(4);
    named(all, name + "/double").answer[1](std::vector{easy, hard, easy, easy}, answers);
    return answers;
  };
  const auto with = [](const Answer& second) {
    return std::vector{Answer::yes(), second, Answer::yes(), Answer::yes()};
  };
  BOOST_TEST((said("crashes") == with(Answer::crashed(11))));
  BOOST_TEST((said("throws")[1].signal == 6));
  BOOST_TEST((said("exits") == with(Answer::crashed(0))));
  BOOST_TEST((said("hangs") == with(Answer::timed_out())));
  BOOST_TEST(!said("closes")[1].is_given());
  BOOST_TEST((said("garbles") == with(Answer::garbage())));
  BOOST_TEST((said("formless") == with(Answer::garbage())));
  BOOST_TEST((said("slow") == with(Answer::yes())));
}

BOOST_AUTO_TEST_CASE(a_batch_that_is_timed_tells_why_it_has_no_answers) {
  const std::vector<Subject> all = subjects_of("misbehaving", 300ms);
  const auto excuse = [&](const std::string& name) -> std::string {
    std::vector<Answer> answers(2);
    try {
      named(all, name).timed[1](std::vector{easy, hard}, answers);
    } catch (const NoAnswer& why) {
      return why.what();
    }
    return "";
  };
  const std::string plugin = from_environment("misbehaving");
  BOOST_TEST(excuse("crashes/double") ==
             "crashes/double does not answer: its plugin " + plugin + " was killed by SIGSEGV");
  BOOST_TEST(excuse("hangs/double") == "hangs/double does not answer: its plugin " + plugin +
                                           " said nothing for 0.3 s and was killed");
}

BOOST_AUTO_TEST_CASE(no_process_is_left_when_the_subjects_go) {
  {
    const std::vector<Subject> all = subjects_of("misbehaving", 300ms);
    for (const Subject& subject : all)
      if (subject.answers(1)) answer_one(subject, hard);
    BOOST_TEST(!children_of(getpid()).empty());
  }
  BOOST_TEST(children_of(getpid()).empty());
  BOOST_TEST(processes_with("serve-plugin " + from_environment("misbehaving")).empty());
}

BOOST_AUTO_TEST_CASE(a_file_that_is_no_plugin_is_refused) {
  const auto refusal = [](const std::string& file) -> std::string {
    try {
      plugin_subjects(file, 2s, from_environment("RAYAUDIT"));
    } catch (const Error& why) {
      return why.what();
    }
    return "it is taken";
  };
  BOOST_TEST(refusal("nowhere.so") ==
             "plugin `nowhere.so` cannot be read: No such file or directory");
  BOOST_TEST(refusal("/tmp") == "plugin `/tmp` is a folder, and no shared object");
  BOOST_TEST(refusal("/etc/passwd") == "plugin `/etc/passwd` cannot be loaded: invalid ELF header");
  BOOST_TEST(refusal("/bin/sh").starts_with("plugin `/bin/sh` cannot be loaded: "));
}

BOOST_AUTO_TEST_CASE(another_version_is_refused_and_both_are_told) {
  BOOST_TEST(refusal_of("no flaw") == "it is taken");
  BOOST_TEST(refusal_of("null") == "is no plugin: its rayaudit_plugin_entry returns null");
  BOOST_TEST(refusal_of("version") ==
             "is of version 7 of rayaudit/plugin.h; known here are those up to 1");
  BOOST_TEST(refusal_of("version 0") ==
             "is of version 0 of rayaudit/plugin.h; known here are those up to 1");
  BOOST_TEST(refusal_of("case size") ==
             "has a rayaudit_case of 136 bytes where version 1 of rayaudit/plugin.h has 200");
  BOOST_TEST(refusal_of("subject size") ==
             "has a rayaudit_subject of 8 bytes where version 1 of rayaudit/plugin.h has 144");
}

BOOST_AUTO_TEST_CASE(a_plugin_without_subjects_is_refused) {
  BOOST_TEST(refusal_of("no subjects") == "names no subjects");
  BOOST_TEST(refusal_of("null subjects") == "names no subjects");
  BOOST_TEST(refusal_of("many subjects") == "says that it has 18446744073709551615 subjects");
}

BOOST_AUTO_TEST_CASE(a_name_that_is_none_or_there_twice_is_refused) {
  BOOST_TEST(refusal_of("null name") == "gives no name of its subject 2");
  const std::string one_word = "a name is one word of letters, digits and `_`, `+`, `-`, `.`";
  BOOST_TEST(refusal_of("empty name") == "has a subject ``: " + one_word);
  BOOST_TEST(refusal_of("two words") == "has a subject `two words`: " + one_word);
  BOOST_TEST(refusal_of("long name") == "gives a name of its subject 2 of more than 63 letters");
  BOOST_TEST(refusal_of("same name") == "has two subjects of the name `first/float`");
  BOOST_TEST(refusal_of("same word") == "it is taken");  // in another format
}

BOOST_AUTO_TEST_CASE(a_format_that_is_none_is_refused) {
  BOOST_TEST(refusal_of("null format") == "gives no format of its subject 2");
  BOOST_TEST(refusal_of("format") ==
             "has a subject `second`: format `flaot` is not known; did you mean `float`?");
}

BOOST_AUTO_TEST_CASE(a_convention_that_cannot_be_meant_is_refused) {
  const std::string second = "has a subject `second`: its convention has ";
  BOOST_TEST(refusal_of("stance") == second + "3 for rim, which is no rayaudit_stance (0, 1 or 2)");
  BOOST_TEST(refusal_of("negative stance") ==
             second + "-1 for within, which is no rayaudit_stance (0, 1 or 2)");
  BOOST_TEST(refusal_of("inside") ==
             second + "77 for inside, which is no rayaudit_inside (0 to 3)");
  BOOST_TEST(refusal_of("range") == second + "the empty range from 2 to 1 for t");
  BOOST_TEST(refusal_of("NaN range") == second + "the empty range from 0 to nan for t");
}

BOOST_AUTO_TEST_CASE(a_subject_without_a_shape_is_refused) {
  BOOST_TEST(refusal_of("no shape") ==
             "has a subject `second`: it answers no shape: disk, sphere, cylinder and all others "
             "are null");
}

BOOST_AUTO_TEST_CASE(a_plugin_that_crashes_or_hangs_while_it_is_loaded_is_refused) {
  BOOST_TEST(refusal_of("crash") == "was killed by SIGSEGV while it was loaded");
  BOOST_TEST(refusal_of("wild name") == "was killed by SIGSEGV while it was loaded");
  BOOST_TEST(refusal_of("exit") == "ended with exit code 3 while it was loaded");
  BOOST_TEST(refusal_of("hang") == "said nothing for 5 s and was killed while it was loaded");
}
