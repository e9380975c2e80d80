#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/answer.hpp"
#include "geometry/case.hpp"
#include "geometry/format.hpp"
#include "subjects/convention.hpp"

namespace rayaudit {

/// An answer with what running error bounds prove of it: that the same operations without rounding
/// would have gone the same way, and how far from its t theirs can be.
struct Proved {
  Answer answer = {};
  bool certified = false;  ///< every comparison is proved, and the bound of t is finite
  double bound = 0;  ///< of |t - the t without rounding|; without a meaning for a miss or a yes
};

/// Whatever answers cases; a built-in one is named `routine/number`.
struct Subject {
  /// Answers cases that are all of one shape: answers[i] is the answer to cases[i].
  using Batch = std::function<void(std::span<const Case>, std::span<Answer>)>;
  using ProvedBatch = std::function<void(std::span<const Case>, std::span<Proved>)>;
  /// The same batch, and the nanoseconds that its answers took.
  using TimedBatch = std::function<double(std::span<const Case>, std::span<Answer>)>;

  std::string name;
  Format format;                          ///< what it works in
  std::array<Batch, shape_count> answer;  ///< by shape; empty where it does not answer the shape
  /// The same answers in numbers with running error bounds; empty where the subject has none.
  std::array<ProvedBatch, shape_count> prove = {};
  /// Of a subject that answers elsewhere, in another process; empty where a clock here will do.
  std::array<TimedBatch, shape_count> timed = {};
  /// An answer takes about so many times as long as one in double: measures take fewer cases.
  int dear = 1;
  /// Is it left out of an audit that names no subjects?
  bool by_name_only = false;
  Convention convention = {};  ///< what it declares
  /// Does it answer in a process of its own? It is then asked in order, from one thread, in batches
  /// of batch_elsewhere, and may answer that it crashed; what is found of it is asked again, alone.
  bool is_elsewhere = false;
  /// What it is, as a plugin tells it: name and version of the library that answers, say.
  std::string about = {};
  /// What a command line must have for it to be there, as `--plugin ./libmine.so`; or nothing.
  std::string brought_by = {};
  /// Of what is brought along: a digest of its plugin's bytes, or of its program's command.
  std::uint64_t made_of = 0;

  bool answers(std::size_t shape) const { return answer[shape] != nullptr; }

  /// The format to draw its cases in, so that they reach it unrounded.
  const Format& drawn_in() const { return format == float_format ? float_format : double_format; }
};

/// May a letter stand in the name of a routine that is brought along? Others mean something to a
/// shell, a glob or a report.
bool is_letter_of_name(char letter);

/// As many cases are put to a subject elsewhere at once, where there are so many.
inline constexpr std::size_t batch_elsewhere = 16'384;

/// A subject that cannot answer: its plugin is missing or breaks off. What is told is a sentence.
struct NoAnswer : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Answers cases of any mix of shapes that the subject answers.
void answer_mixed(const Subject& subject, std::span<const Case> cases, std::span<Answer> answers);
Answer answer_one(const Subject& subject, const Case& question);

/// Every routine in float, double and long double, and the certified ones.
const std::vector<Subject>& built_in_subjects();

/// Every subject of the project: the built-in ones, then those that are asked for by name only. The
/// libraries' are loaded when they are asked for (libraries/libraries.hpp).
const std::vector<Subject>& all_subjects();

/// Subjects that this build or this place does not have.
struct Absent {
  std::string subjects;  ///< a name, or a glob for many
  std::string why;       ///< a sentence
};
std::vector<Absent> absent_subjects();

}  // namespace rayaudit
