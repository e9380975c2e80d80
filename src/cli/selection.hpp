#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "families/family.hpp"
#include "subjects/libraries/libraries.hpp"
#include "subjects/plugins.hpp"
#include "subjects/program.hpp"
#include "subjects/subject.hpp"

namespace rayaudit {

/// The seed of all that is drawn where no other is asked for.
inline constexpr std::uint64_t default_seed = 1;

/// The most cases that can be drawn: all counts of a run stay far from overflow.
inline constexpr std::int64_t largest_cases = 1'000'000'000'000'000;

/// What a command line says of subjects.
struct SubjectChoice {
  std::vector<std::string> names;    ///< and globs
  std::vector<std::string> plugins;  ///< files
  std::string program;               ///< a shell command, or empty
  Format format = double_format;     ///< what that works in
  std::optional<std::chrono::milliseconds> patience;

  bool brings_any() const { return !plugins.empty() || !program.empty(); }
};

/// Subjects to choose from: those that a command line brings along, then all of ours, then those of
/// the libraries that were asked for.
class Subjects {
 public:
  /// Loads what is brought along, and what libraries the names can only mean. Throws Error where
  /// that cannot be, or a name is taken already.
  explicit Subjects(const SubjectChoice& choice);
  Subjects(const Subjects&) = delete;
  Subjects& operator=(const Subjects&) = delete;

  const std::vector<Subject>& brought() const { return brought_; }
  /// They stand as long as this does.
  const std::vector<const Subject*>& all() const { return all_; }

  /// What stands for many stands for: those of every audit, and where it matches none of them any;
  /// or every subject there is.
  enum class Unnamed { usual, every };
  /// The subjects of the choice. What is brought along is among them, unless names choose of it;
  /// without names there is nothing else, and where nothing is brought along either, all. Throws
  /// Error where a name is not known, NothingAudited where a glob matches nothing.
  std::vector<const Subject*> selected(const SubjectChoice& choice,
                                       Unnamed unnamed = Unnamed::usual) const;

  /// Loads the libraries, once each, whose subjects a name or glob can only mean: `embree/float`,
  /// `coin*`, but neither `*/float` nor what any other subject is called. Throws Error where a
  /// plugin cannot be loaded, or none of those meant is there.
  void load(const std::string& pattern);

  /// The subject of a name, loaded with its library if it is one's; throws Error where there is
  /// none.
  const Subject& named(const std::string& name);
  /// Null where there is none.
  const Subject* find(const std::string& name);

 private:
  void load(const Library& library);
  void add(std::vector<Subject> subjects, const std::string& brought_by, std::string_view made_of);

  std::vector<Subject> brought_;
  std::map<std::string_view, std::vector<Subject>> loaded_;  ///< by the plugin of their library
  std::vector<const Subject*> all_;
};

/// Throws Error where a name or glob asks for subjects that this build or place does not have.
void require_present(const std::vector<std::string>& patterns);

/// The shapes that a family draws.
std::vector<std::size_t> shapes_of(const Family& family);

/// Throws Error unless the difficulty lies in the range that the family has in the format.
void require_difficulty(const Family& family, const Format& format, int difficulty);

}  // namespace rayaudit
