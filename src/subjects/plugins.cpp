#include "subjects/plugins.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <system_error>

#include "geometry/error.hpp"
#include "geometry/quotation.hpp"
#include "geometry/unknown_name.hpp"
#include "subjects/flat_convention.hpp"
#include "subjects/plugin_child.hpp"
#include "subjects/unbroken.hpp"

namespace rayaudit {
namespace {

namespace fs = std::filesystem;

constexpr std::array formats = {float_format, double_format, long_double_format};

/// A mistake in what a plugin says of a subject.
Error mistake(const PluginSubject& subject, const std::string& what) {
  return Error{"has a subject " + quotation(subject.name) + ": " + what};
}

const Format& format_of_name(const PluginSubject& subject) {
  const std::string_view name = subject.format;
  const auto found = std::find_if(formats.begin(), formats.end(),
                                  [&](const Format& format) { return format.name == name; });
  if (found != formats.end()) return *found;
  std::array<std::string_view, formats.size()> known;
  std::transform(formats.begin(), formats.end(), known.begin(),
                 [](const Format& format) { return format.name; });
  throw mistake(subject, unknown_name("format", name, known));
}

Convention convention_of(const PluginSubject& subject) {
  try {
    return from_flat(subject.convention);
  } catch (const Error& why) {
    throw mistake(subject, why.what());
  }
}

void require_word(const PluginSubject& subject) {
  const std::string_view name = subject.name;
  if (name.empty() || !std::all_of(name.begin(), name.end(), is_letter_of_name))
    throw mistake(subject, "a name is one word of letters, digits and `_`, `+`, `-`, `.`");
}

void require_shape(const PluginSubject& subject) {
  if (std::none_of(std::begin(subject.answers), std::end(subject.answers),
                   [](bool answers) { return answers; }))
    throw mistake(subject, "it answers no shape: disk, sphere, cylinder and all others are null");
}

/// A subject in a child of its own.
Subject subject_of(const PluginSubject& said, const fs::path& program, const fs::path& plugin,
                   std::chrono::milliseconds patience) {
  require_word(said);
  require_shape(said);
  Subject made = {std::string(said.name) + '/' + said.format, format_of_name(said), {}};
  made.about = said.about;
  made.convention = convention_of(said);
  made.is_elsewhere = true;
  const auto child = std::make_shared<PluginChild>(program, plugin, patience);
  for (std::size_t shape = 0; shape < shape_count; ++shape) {
    if (!said.answers[shape]) continue;
    const auto unbroken = std::make_shared<Unbroken>(
        [child, name = made.name, shape](std::span<const Case> cases, std::span<Answer> answers,
                                         Manner manner) {
          return child->ask(name, shape, cases, answers, manner);
        },
        patience);
    made.answer[shape] = [unbroken](std::span<const Case> cases, std::span<Answer> answers) {
      unbroken->answer(cases, answers);
    };
    made.timed[shape] = [child, name = made.name, shape](std::span<const Case> cases,
                                                         std::span<Answer> answers) {
      return child->answer(name, shape, cases, answers);
    };
  }
  return made;
}

std::vector<PluginSubject> said_by(const fs::path& program, const fs::path& plugin,
                                   std::chrono::milliseconds patience) {
  std::error_code fault;
  const fs::file_status status = fs::status(plugin, fault);
  if (!fs::exists(status)) throw Error("cannot be read: " + fault.message());
  if (fs::is_directory(status)) throw Error("is a folder, and no shared object");
  try {
    return PluginChild(program, fs::absolute(plugin), patience).subjects();
  } catch (const PluginChild::Unloaded& why) {
    throw Error(why.sentence);
  }
}

void require_different(const std::vector<Subject>& subjects) {
  for (auto subject = subjects.begin(); subject != subjects.end(); ++subject)
    if (std::any_of(subjects.begin(), subject,
                    [&](const Subject& before) { return before.name == subject->name; }))
      throw Error("has two subjects of the name " + quotation(subject->name));
}

}  // namespace

std::optional<fs::path> plugin_beside(const fs::path& program, std::string_view name) {
  const std::string file = "rayaudit-" + std::string(name) + ".so";
  std::error_code fault;
  const fs::path folder = fs::canonical(program, fault).parent_path();
  for (const fs::path& place : {folder, folder.parent_path() / "lib" / "rayaudit"})
    if (fs::path plugin = place / file; fs::exists(plugin, fault)) return plugin;
  return {};
}

std::vector<Subject> plugin_subjects(const fs::path& plugin, std::chrono::milliseconds patience,
                                     const fs::path& program) {
  try {
    std::vector<Subject> subjects;
    for (const PluginSubject& said : said_by(program, plugin, patience))
      subjects.push_back(subject_of(said, program, fs::absolute(plugin), patience));
    require_different(subjects);
    return subjects;
  } catch (const Error& what) {
    throw Error("plugin `" + plugin.string() + "` " + what.what());
  }
}

}  // namespace rayaudit
