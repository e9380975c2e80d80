#include "subjects/libraries/libraries.hpp"

#include <array>
#include <memory>
#include <mutex>
#include <string>

#include "subjects/plugins.hpp"

namespace rayaudit {
namespace {

namespace fs = std::filesystem;

/// What is known of a plugin's one subject before it is loaded.
struct Library {
  std::string_view name;
  Format format;
  Convention convention;  ///< as the plugin declares it
  std::string_view needs;
};

const std::array libraries = {
    Library{"embree", float_format, {.t_min = 0}, "Embree 3 (Debian's libembree-dev)"}};

/// The subject of a plugin, which is loaded when it is first asked.
class Loaded {
 public:
  Loaded(fs::path plugin, fs::path program)
      : plugin_(std::move(plugin)), program_(std::move(program)) {}

  const Subject& subject() {
    std::call_once(once_, [&] { subjects_ = plugin_subjects(plugin_, plugin_patience, program_); });
    return subjects_.front();
  }

 private:
  const fs::path plugin_, program_;
  std::once_flag once_;
  std::vector<Subject> subjects_;
};

Subject subject_of(const Library& library, const fs::path& plugin, const fs::path& program) {
  Subject made = {
      std::string(library.name) + '/' + std::string(library.format.name), library.format, {}};
  made.convention = library.convention;
  made.is_elsewhere = true;
  const auto loaded = std::make_shared<Loaded>(plugin, program);
  for (std::size_t shape = 0; shape < shape_count; ++shape) {
    made.answer[shape] = [loaded, shape](std::span<const Case> cases, std::span<Answer> answers) {
      loaded->subject().answer[shape](cases, answers);
    };
    made.timed[shape] = [loaded, shape](std::span<const Case> cases, std::span<Answer> answers) {
      return loaded->subject().timed[shape](cases, answers);
    };
  }
  return made;
}

}  // namespace

std::vector<Subject> libraries_beside(const fs::path& program) {
  std::vector<Subject> subjects;
  for (const Library& library : libraries)
    if (const auto plugin = plugin_beside(program, library.name))
      subjects.push_back(subject_of(library, *plugin, program));
  return subjects;
}

std::vector<Subject> library_subjects() { return libraries_beside(this_program); }

std::vector<Absent> absent_libraries() {
  std::vector<Absent> absent;
  for (const Library& library : libraries)
    if (!plugin_beside(this_program, library.name))
      absent.push_back({std::string(library.name) + "/*",
                        "rayaudit-" + std::string(library.name) +
                            ".so is not beside the program; it is built where there is " +
                            std::string(library.needs)});
  return absent;
}

}  // namespace rayaudit
