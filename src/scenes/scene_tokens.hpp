#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scenes/read_scene.hpp"

/// The grammar of scene files: words, strings in double quotes, brackets, and comments from # to
/// the end of their line; a directive is a word and what follows it up to the next one.
namespace rayaudit {

struct Token {
  enum class Kind : std::uint8_t { word, string, open, close, end };
  Kind kind = Kind::end;
  std::string_view text = {};         ///< of a string what stands between its quotes, as it stands
  const std::string* file = nullptr;  ///< its name
  int line = 1, column = 1;

  Place place() const { return {*file, line, column}; }
};

/// As a sentence has it: between backquotes, or `the end of the file`.
std::string told(const Token& token);

[[noreturn]] void refuse(const Token& token, const std::string& what);

/// Decimal or hex float, in any locale; throws SceneError where it is none, or not finite. The
/// owner and the label are for that sentence.
double read_number(const Token& token, std::string_view owner, std::string_view label);

/// The tokens of a text, one after another. Both the text and the name of its file must outlive
/// them.
class Tokens {
 public:
  Tokens(std::string_view text, const std::string& file);

  const Token& peek() const { return ahead_; }
  Token next();

  /// The string that comes next; throws SceneError where none does, and tells what it would be.
  Token string(std::string_view owner, std::string_view what);
  /// So many numbers, between brackets or not.
  std::vector<double> numbers(std::string_view owner, std::size_t count);
  /// Leaves out all up to the next directive.
  void skip_arguments();

 private:
  Token scan();
  void skip_blanks();
  Token scan_string();

  std::string_view text_;
  const std::string* file_;
  std::size_t at_ = 0, line_begin_ = 0;
  int line_ = 1;
  Token ahead_;
};

/// Can a word of a file be no directive: a number, true or false?
bool is_value(std::string_view word);

}  // namespace rayaudit
