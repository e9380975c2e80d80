#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "geometry/answer.hpp"
#include "geometry/case.hpp"

namespace rayaudit {

/// What stands against a program as a whole, as a sentence about it goes on.
struct Fault {
  std::string what;
};

/// Takes what a program prints, piece by piece: the answers to cases, in their order, each behind
/// its case repeated. Blank lines and comments are passed over. Throws Fault at the first line that
/// is anything else.
class AnswerLines {
 public:
  /// The answers are written as they come.
  AnswerLines(std::span<const Case> cases, std::span<Answer> answers)
      : cases_(cases), answers_(answers) {}

  void take(std::string_view piece);
  /// Nothing comes any more; the last line may lack its end. Throws Fault unless it is complete.
  void end();

  std::size_t answered() const { return answered_; }
  bool is_complete() const { return answered_ == cases_.size(); }
  /// As in `3 of 10 answers`.
  std::string progress() const;

 private:
  void take_line();
  void take_answer(const std::string& line);
  [[noreturn]] void refuse(const std::string& line, const std::string& why) const;
  std::string told_other(const Case& said) const;

  std::span<const Case> cases_;
  std::span<Answer> answers_;
  std::size_t answered_ = 0;
  std::size_t number_ = 0;    ///< of the line that is being read
  std::size_t comments_ = 0;  ///< and blank lines
  std::string begun_;         ///< what has come of that line
};

}  // namespace rayaudit
