#include "scenes/scene_tokens.hpp"

#include <cmath>

#include "geometry/number_text.hpp"
#include "geometry/quotation.hpp"

namespace rayaudit {
namespace {

bool is_blank(char letter) {
  return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r' || letter == '\f' ||
         letter == '\v';
}

bool ends_word(char letter) {
  return is_blank(letter) || letter == '"' || letter == '[' || letter == ']' || letter == '#';
}

}  // namespace

std::string told(const Token& token) {
  return token.kind == Token::Kind::end ? "the end of the file" : quotation(token.text);
}

void refuse(const Token& token, const std::string& what) { throw SceneError(token.place(), what); }

double read_number(const Token& token, std::string_view owner, std::string_view label) {
  if (token.kind != Token::Kind::word)
    refuse(token, std::string(owner) + ": expected " + std::string(label) + ", got " + told(token));
  try {
    const double number = read_double(token.text, {owner, label});
    if (std::isfinite(number)) return number;
  } catch (const Error& fault) {
    refuse(token, fault.what());
  }
  refuse(token, std::string(owner) + ": " + std::string(label) + " must be finite");
}

bool is_value(std::string_view word) {
  const char first = word.empty() ? ' ' : word.front();
  return (first >= '0' && first <= '9') || first == '-' || first == '+' || first == '.' ||
         word == "true" || word == "false";
}

Tokens::Tokens(std::string_view text, const std::string& file) : text_(text), file_(&file) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text_.starts_with(byte_order_mark)) at_ = line_begin_ = byte_order_mark.size();
  ahead_ = scan();
}

Token Tokens::next() {
  const Token token = ahead_;
  if (token.kind != Token::Kind::end) ahead_ = scan();
  return token;
}

void Tokens::skip_blanks() {
  bool in_comment = false;
  for (; at_ < text_.size(); ++at_) {
    const char letter = text_[at_];
    if (letter == '\n') {
      ++line_;
      line_begin_ = at_ + 1;
      in_comment = false;
    } else if (letter == '#') {
      in_comment = true;
    } else if (!in_comment && !is_blank(letter)) {
      return;
    }
  }
}

Token Tokens::scan() {
  skip_blanks();
  Token token = {Token::Kind::end, {}, file_, line_, static_cast<int>(at_ - line_begin_) + 1};
  if (at_ == text_.size()) return token;
  const std::size_t begin = at_++;
  if (text_[begin] == '"') return scan_string();
  if (text_[begin] == '[') {
    token.kind = Token::Kind::open;
  } else if (text_[begin] == ']') {
    token.kind = Token::Kind::close;
  } else {
    token.kind = Token::Kind::word;
    while (at_ < text_.size() && !ends_word(text_[at_])) ++at_;
  }
  token.text = text_.substr(begin, at_ - begin);
  return token;
}

Token Tokens::scan_string() {
  const std::size_t begin = at_;
  Token token = {Token::Kind::string, {}, file_, line_, static_cast<int>(begin - line_begin_)};
  for (; at_ < text_.size() && text_[at_] != '\n'; ++at_) {
    if (text_[at_] == '"') {
      token.text = text_.substr(begin, at_++ - begin);
      return token;
    }
    if (text_[at_] == '\\' && at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
  }
  refuse(token, "a string without its closing quote on the same line");
}

Token Tokens::string(std::string_view owner, std::string_view what) {
  if (ahead_.kind != Token::Kind::string)
    refuse(ahead_, std::string(owner) + ": expected " + std::string(what) +
                       " between double quotes, got " + told(ahead_));
  return next();
}

std::vector<double> Tokens::numbers(std::string_view owner, std::size_t count) {
  const bool bracketed = ahead_.kind == Token::Kind::open;
  if (bracketed) next();
  std::vector<double> numbers;
  numbers.reserve(count);
  while (numbers.size() < count) {
    // The sentence is made only where it is needed.
    if (ahead_.kind != Token::Kind::word || !is_value(ahead_.text))
      refuse(ahead_, std::string(owner) + ": expected number " +
                         std::to_string(numbers.size() + 1) + " of " + std::to_string(count) +
                         ", got " + told(ahead_));
    numbers.push_back(read_number(ahead_, owner, "a number"));
    next();
  }
  if (bracketed && ahead_.kind != Token::Kind::close)
    refuse(ahead_, std::string(owner) + ": expected `]`, got " + told(ahead_));
  if (bracketed) next();
  return numbers;
}

void Tokens::skip_arguments() {
  Token opened = {};
  for (;; next()) {
    const bool open = opened.kind == Token::Kind::open;
    if (ahead_.kind == Token::Kind::end && open) refuse(opened, "`[` without its `]`");
    if (ahead_.kind == Token::Kind::end) return;
    if (ahead_.kind == Token::Kind::word && !is_value(ahead_.text)) {
      if (open) refuse(ahead_, "expected a value or `]`, got " + told(ahead_));
      return;
    }
    if (ahead_.kind == Token::Kind::open && open) refuse(ahead_, "a `[` inside of brackets");
    if (ahead_.kind == Token::Kind::close && !open) refuse(ahead_, "a `]` without its `[`");
    if (ahead_.kind == Token::Kind::open || ahead_.kind == Token::Kind::close) opened = ahead_;
  }
}

}  // namespace rayaudit
