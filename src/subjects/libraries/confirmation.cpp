#include "subjects/libraries/confirmation.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "geometry/case_line.hpp"
#include "geometry/error.hpp"
#include "subjects/plugins.hpp"
#include "subjects/program_run.hpp"

namespace rayaudit {
namespace {

namespace fs = std::filesystem;

/// So long a program may take to be built, and to say its answer, without a word in between.
constexpr std::chrono::milliseconds patience_to_build = std::chrono::seconds(120),
                                    patience_to_run = std::chrono::seconds(10);

/// A folder for one program, gone at the end.
class Workplace {
 public:
  /// With the packages from npm that lie beside a program, where a script finds them.
  explicit Workplace(const fs::path& program) {
    std::string name = (fs::temp_directory_path() / "rayaudit-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw Error("no folder can be made for a program");
    path_ = name;
    std::error_code fault;
    const fs::path here = fs::canonical(program, fault).parent_path();
    if (const fs::path packages = here / "npm/node_modules"; fs::exists(packages, fault))
      fs::create_directory_symlink(packages, path_ / "node_modules", fault);
  }
  ~Workplace() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void replace(std::string& text, std::string_view word, const std::string& by) {
  if (const std::size_t at = text.find(word); at != text.npos) text.replace(at, word.size(), by);
}

/// What is left of a command that would fetch packages first: nothing is fetched for this.
std::string without_fetching(const std::string& command) {
  const std::size_t then = command.find(" && ");
  return command.starts_with("npm install ") && then != command.npos ? command.substr(then + 4)
                                                                     : command;
}

/// How a command ended, and what it printed; what on standard error, which is nobody else's.
struct Ended {
  ProgramEnd end;
  std::string text, errors;

  bool is_well() const {
    return !end.is_hung && WIFEXITED(end.status) && WEXITSTATUS(end.status) == 0;
  }
};

Ended ended(const std::string& command, const fs::path& folder,
            std::chrono::milliseconds patience) {
  Ended made;
  made.end = run_program("cd '" + folder.string() + "' && { " + command + "\n} 2>errors", "",
                         patience, [&](std::string_view part) { made.text += part; });
  std::ostringstream errors;
  errors << std::ifstream(folder / "errors").rdbuf();
  made.errors = errors.str();
  return made;
}

std::string last_line(std::string_view text) {
  while (!text.empty() && text.back() == '\n') text.remove_suffix(1);
  const std::size_t last = text.rfind('\n');
  return std::string(last == text.npos ? text : text.substr(last + 1));
}

/// What the compiler says first is nearer to the reason than what it says last.
std::string first_error(const std::string& text) {
  for (const std::string_view word : {"rror: ", "ERR", "not found", "No such"})
    if (const std::size_t at = text.find(word); at != text.npos) {
      const std::size_t start = text.rfind('\n', at) + 1;
      return text.substr(start, text.find('\n', at) - start);
    }
  return last_line(text);
}

/// What a program did instead; empty where it is what the answer says.
std::string difference(const Ended& run, const Case& question, const Answer& answer) {
  if (answer.form == Answer::Form::timed_out) return run.end.is_hung ? "" : "it ends";
  if (run.end.is_hung) return "it does not end";
  if (answer.form == Answer::Form::crashed) return run.is_well() ? "it does not crash" : "";
  if (says(run.text, question, answer)) return "";
  if (!run.is_well()) return "it fails: " + first_error(run.errors);
  return fmt::format("it prints `{}`, and not `{}`", last_line(run.text), printed(answer));
}

std::string number(const Real& x) {
  const double shown = nearest<double>(x);
  return std::isinf(shown) ? (shown < 0 ? "-inf" : "inf") : fmt::format("{}", shown);
}

}  // namespace

std::string printed(const Answer& answer) {
  switch (answer.form) {
    case Answer::Form::hit:
      return "hit " + number(answer.t);
    case Answer::Form::at:
      return fmt::format("at {} {} {}", number(answer.point.x), number(answer.point.y),
                         number(answer.point.z));
    default: {
      std::string text;
      write(text, answer);
      return text;
    }
  }
}

bool says(std::string_view output, const Case& question, const Answer& answer) {
  try {
    const CaseLine read = read_case_line(case_line(question) + ' ' + last_line(output));
    return read.answer && read.answer->form == answer.form &&
           printed(*read.answer) == printed(answer);
  } catch (const Error&) {
    return false;
  }
}

std::string why_unconfirmed(const OutsideProgram& program, const Case& question,
                            const Answer& answer, const fs::path& beside) {
  const Workplace folder(beside);
  std::ofstream(folder.path() / program.file) << program.text;
  std::string build = without_fetching(program.build);
  replace(build, "FILE", program.file);
  if (build.find("PROGRAM") == build.npos)
    return difference(ended(build, folder.path(), patience_to_build), question, answer);
  replace(build, "PROGRAM", "program");
  const Ended built = ended(build, folder.path(), patience_to_build);
  if (!built.is_well()) return "it cannot be built: " + first_error(built.errors);
  return difference(ended("./program", folder.path(), patience_to_run), question, answer);
}

}  // namespace rayaudit
