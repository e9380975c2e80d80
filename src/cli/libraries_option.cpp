#include "cli/libraries_option.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>

#include "cli/exit_code.hpp"
#include "cli/names.hpp"
#include "cli/option.hpp"
#include "cli/output.hpp"
#include "geometry/unknown_name.hpp"
#include "subjects/libraries/libraries.hpp"

namespace rayaudit {
namespace {

/// A name in its parts: `coin_pick`, and `float` or `sphere` where that follows.
struct Wanted {
  std::string name, who;
  std::string_view what;

  explicit Wanted(const std::string& text)
      : name(text), who(text.substr(0, text.find('/'))), what(name) {
    what.remove_prefix(std::min(who.size() + 1, name.size()));
  }
  Wanted(const Wanted&) = delete;
  Wanted& operator=(const Wanted&) = delete;
};

std::optional<std::size_t> shape_of(std::string_view what) {
  const auto found = std::find(shape_names.begin(), shape_names.end(), what);
  if (found == shape_names.end()) return {};
  return static_cast<std::size_t>(found - shape_names.begin());
}

/// The libraries that a name may be of: the one of that name, else those that may have a subject of
/// it.
std::vector<const Library*> meant_by(const Wanted& wanted) {
  std::vector<const Library*> meant;
  for (const Library& library : libraries())
    if (library.plugin == wanted.who) return {&library};
  for (const Library& library : libraries())
    if (wanted.who.starts_with(library.stem())) meant.push_back(&library);
  if (!meant.empty()) return meant;
  throw Error(unknown_name("library", wanted.who, names_of(libraries(), &Library::plugin)));
}

bool is_of(const Wanted& wanted, const Library& library, const Subject& subject) {
  const std::string_view routine =
      std::string_view(subject.name).substr(0, subject.name.rfind('/'));
  if (wanted.who != library.plugin && wanted.who != routine) return false;
  const std::string_view format = std::string_view(subject.name).substr(routine.size() + 1);
  if (wanted.what.empty() || wanted.what == format) return true;
  const auto shape = shape_of(wanted.what);
  return shape && subject.answers(*shape);
}

/// A library's subjects, loaded once; none where they cannot be, which is told.
class Loaded {
 public:
  const std::vector<Subject>& subjects_of(const Library& library) {
    const auto [place, is_new] = subjects_.try_emplace(library.plugin);
    if (is_new) place->second = load(library);
    return place->second;
  }

 private:
  static std::vector<Subject> load(const Library& library) {
    try {
      return rayaudit::subjects_of(library);
    } catch (const Error& why) {
      complain(fmt::format("{} is left out: {}", library.plugin, why.what()));
      return {};
    }
  }

  std::map<std::string_view, std::vector<Subject>> subjects_;
};

/// Adds what a subject is asked for: one shape, or all.
void add(std::deque<Subject>& chosen, const Subject& subject, std::optional<std::size_t> shape) {
  const auto same = std::find_if(chosen.begin(), chosen.end(),
                                 [&](const Subject& each) { return each.name == subject.name; });
  const bool is_new = same == chosen.end();
  Subject& made = is_new ? chosen.emplace_back(subject) : *same;
  for (std::size_t i = 0; i < shape_count; ++i) {
    if (!shape || i == *shape)
      made.answer[i] = subject.answer[i], made.timed[i] = subject.timed[i];
    else if (is_new)
      made.answer[i] = nullptr, made.timed[i] = nullptr;
  }
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const Library& library : libraries()) names.emplace_back(library.plugin);
  return names;
}

}  // namespace

CLI::Option* add_libraries_option(CLI::App& command, LibrariesOption& libraries) {
  return add_option(
             command, "--libraries", "NAME,...",
             "audit libraries that people ship, all that are here or those named: a library, "
             "one shape of it as embree/sphere, a subject as coin_pick/float",
             [&libraries](const std::string& text) {
               std::istringstream names(text);
               for (std::string name; std::getline(names, name, ',');)
                 if (!name.empty()) libraries.names.push_back(name);
             })
      ->expected(0, 1);
}

std::deque<Subject> loaded_libraries(const std::vector<std::string>& names) {
  std::deque<Subject> chosen;
  Loaded loaded;
  for (const std::string& name : names.empty() ? all_names() : names) {
    const Wanted wanted(name);
    bool is_any = false, is_loaded = false;
    for (const Library* library : meant_by(wanted))
      for (const Subject& subject : loaded.subjects_of(*library)) {
        is_loaded = true;
        if (!is_of(wanted, *library, subject)) continue;
        is_any = true;
        add(chosen, subject, shape_of(wanted.what));
      }
    if (is_loaded && !is_any)
      throw Error(fmt::format(
          "--libraries: nothing is called `{}`: rayaudit list libraries tells what there is",
          name));
  }
  if (chosen.empty())
    throw NothingAudited("nothing to audit: no library that is asked for is here");
  return chosen;
}

}  // namespace rayaudit
