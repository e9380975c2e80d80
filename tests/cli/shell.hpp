#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>

/// The program as its users run it: shell lines in a folder of their own, in which `rayaudit` is
/// the program that the environment variable RAYAUDIT names.
namespace shell {

/// How a shell line ended.
struct Ended {
  int code = 0;  ///< 128 and more: of a signal
  std::string out, err;

  friend bool operator==(const Ended&, const Ended&) = default;
  friend std::ostream& operator<<(std::ostream& to, const Ended& ended) {
    return to << "exit code " << ended.code << "\n" << ended.out << "---\n" << ended.err;
  }
};

inline std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// A folder for the files of one shell line after the other; gone at the end.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "rayaudit-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) std::abort();
    path_ = name;
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  Ended run(const std::string& line) const {
    const char* program = std::getenv("RAYAUDIT");
    if (program == nullptr) throw std::runtime_error("RAYAUDIT does not name the program");
    std::ofstream(path_ / ".line")
        << "set -o pipefail\nrayaudit() { '" << program << "' \"$@\"; }\n"
        << line << '\n';
    const std::string command =
        "cd '" + path_.string() + "' && timeout 100 bash .line </dev/null >.out 2>.err";
    const int status = std::system(command.c_str());
    return {WEXITSTATUS(status), text(".out"), text(".err")};
  }

  std::string text(const std::string& file) const { return text_of(path_ / file); }
  void write(const std::string& file, const std::string& text) const {
    std::ofstream(path_ / file) << text;
  }

  /// How many files there are that the lines have left, of the names without a dot in front.
  auto files() const {
    return std::count_if(std::filesystem::directory_iterator(path_), {}, [](const auto& entry) {
      return entry.path().filename().string()[0] != '.';
    });
  }

 private:
  std::filesystem::path path_;
};

/// Runs one line in a new folder.
inline Ended run(const std::string& line) { return Folder().run(line); }

inline Ended printed(const std::string& out) { return {0, out, ""}; }

/// The program's own refusal: one sentence on standard error and nothing else.
inline Ended refused(int code, const std::string& sentence) {
  return {code, "", "rayaudit: " + sentence + "\n"};
}

inline auto line_count(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

}  // namespace shell
