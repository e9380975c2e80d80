#include "cli/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "cli/command_text.hpp"
#include "cli/names.hpp"
#include "cli/whole_file.hpp"
#include "geometry/digest.hpp"
#include "geometry/error.hpp"
#include "geometry/glob.hpp"

namespace rayaudit {
namespace {

/// Does a pattern stand for a subject that is asked for by name only?
bool reaches(const std::string& pattern, const std::vector<const Subject*>& all,
             const Subject& subject) {
  if (!subject.by_name_only || !is_glob(pattern)) return true;
  return std::none_of(all.begin(), all.end(), [&](const Subject* each) {
    return !each->by_name_only && matches(pattern, each->name);
  });
}

/// Can a name or glob mean subjects of a library, and no others that we know of?
bool means(const std::string& pattern, const std::vector<const Subject*>& all,
           const Library& library) {
  const std::string_view stem = library.stem();
  const std::string_view start = std::string_view(pattern).substr(0, pattern.find_first_of("*?["));
  const auto is_other = [&](const Subject* each) {
    return each->brought_by.empty() ? each->name == pattern : matches(pattern, each->name);
  };
  if (std::any_of(all.begin(), all.end(), is_other)) return false;
  if (start.starts_with(stem)) return true;
  if (!is_glob(pattern) || start.empty() || !stem.starts_with(start)) return false;
  return std::none_of(all.begin(), all.end(),
                      [&](const Subject* each) { return matches(pattern, each->name); });
}

std::vector<std::string_view> names_of(const std::vector<const Subject*>& subjects) {
  std::vector<std::string_view> names;
  names.reserve(subjects.size());
  for (const Subject* subject : subjects) names.push_back(subject->name);
  return names;
}

[[noreturn]] void refuse_absent(const std::string& pattern, const std::string& why) {
  throw Error(fmt::format("subject `{}` is not here: {}", pattern, why));
}

}  // namespace

void require_present(const std::vector<std::string>& patterns) {
  for (const std::string& pattern : patterns)
    for (const auto& [subjects, why] : absent_subjects())
      if (matches(subjects, pattern)) refuse_absent(pattern, why);
}

Subjects::Subjects(const SubjectChoice& choice) {
  if (choice.patience && !choice.brings_any())
    throw Error("--patience goes with --plugin or --program");
  for (const std::string& file : choice.plugins) {
    // Loaded first: of a plugin that is not there that tells more than its bytes do.
    auto loaded = plugin_subjects(file, choice.patience.value_or(plugin_patience));
    add(std::move(loaded), "--plugin " + quoted(file), read_whole(file).text);
  }
  if (!choice.program.empty())
    add({program_subject(choice.program, choice.format, choice.patience.value_or(usual_patience))},
        fmt::format("--program {} --format {}", quoted(choice.program), choice.format.name),
        choice.program);
  for (const Subject& subject : brought_) all_.push_back(&subject);
  for (const Subject& subject : all_subjects()) all_.push_back(&subject);
  // Behind an `@` stands the offset that a scene is traced with.
  for (const std::string& name : choice.names) load(name.substr(0, name.rfind('@')));
}

void Subjects::load(const std::string& pattern) {
  std::vector<const Library*> meant;
  for (const Library& library : libraries())
    if (means(pattern, all_, library)) meant.push_back(&library);
  bool is_any_here = meant.empty();
  for (const Library* library : meant) {
    if (!is_here(*library)) {
      if (matches(std::string(library->subjects), pattern))
        refuse_absent(pattern, why_absent(*library));
      continue;
    }
    is_any_here = true;
    if (!loaded_.contains(library->plugin)) load(*library);
  }
  if (!is_any_here) refuse_absent(pattern, why_absent(*meant.front()));
}

void Subjects::load(const Library& library) {
  std::vector<Subject>& loaded = loaded_[library.plugin] = subjects_of(library);
  for (const Subject& subject : loaded) {
    if (std::any_of(brought_.begin(), brought_.end(),
                    [&](const Subject& each) { return each.name == subject.name; }))
      throw Error(fmt::format("a subject `{}` is brought along, and a library has one of this name",
                              subject.name));
    all_.push_back(&subject);
  }
}

void Subjects::add(std::vector<Subject> subjects, const std::string& brought_by,
                   std::string_view made_of) {
  Digest digest;
  digest.add(made_of);
  for (Subject& subject : subjects) {
    const auto is_of_name = [&](const Subject& each) { return each.name == subject.name; };
    const std::vector<Subject>& here = all_subjects();
    if (std::any_of(brought_.begin(), brought_.end(), is_of_name) ||
        std::any_of(here.begin(), here.end(), is_of_name))
      throw Error(fmt::format("{} brings a subject `{}`, and there is one of this name already",
                              brought_by, subject.name));
    subject.brought_by = brought_by;
    subject.made_of = digest.value();
  }
  std::move(subjects.begin(), subjects.end(), std::back_inserter(brought_));
}

std::vector<const Subject*> Subjects::selected(const SubjectChoice& choice, Unnamed unnamed) const {
  require_present(choice.names);
  std::vector<bool> chosen(all_.size());
  const bool wants_all = choice.names.empty() && brought_.empty();
  for (const std::string& pattern : wants_all ? std::vector<std::string>{"*"} : choice.names)
    for (const std::size_t i : rayaudit::selected("subject", {pattern}, names_of(all_)))
      if (unnamed == Unnamed::every || reaches(pattern, all_, *all_[i])) chosen[i] = true;
  // What is brought along is audited beside the others, unless names choose of it.
  const auto brought_end = chosen.begin() + static_cast<std::ptrdiff_t>(brought_.size());
  if (std::find(chosen.begin(), brought_end, true) == brought_end)
    std::fill(chosen.begin(), brought_end, true);
  std::vector<const Subject*> subjects;
  for (std::size_t i = 0; i < all_.size(); ++i)
    if (chosen[i]) subjects.push_back(all_[i]);
  return subjects;
}

const Subject* Subjects::find(const std::string& name) {
  load(name);
  const auto found = std::find_if(all_.begin(), all_.end(),
                                  [&](const Subject* each) { return each->name == name; });
  return found == all_.end() ? nullptr : *found;
}

const Subject& Subjects::named(const std::string& name) {
  load(name);
  return *all_[place_of("subject", name, names_of(all_))];
}

std::vector<std::size_t> shapes_of(const Family& family) {
  std::vector<std::size_t> shapes;
  for (std::size_t shape = 0; shape < shape_count; ++shape)
    if (family.draw[shape] != nullptr) shapes.push_back(shape);
  return shapes;
}

void require_difficulty(const Family& family, const Format& format, int difficulty) {
  const int least = family.difficulty->least, most = family.difficulty->most(format);
  if (difficulty < least || difficulty > most)
    throw Error(fmt::format("--difficulty {} is not one of family `{}` in {}: {} to {}", difficulty,
                            family.id, format.name, least, most));
}

}  // namespace rayaudit
