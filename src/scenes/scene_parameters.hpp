#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "scenes/scene_notes.hpp"
#include "scenes/scene_tokens.hpp"

namespace rayaudit {

/// `"type name" [values]` after a directive. Where a name stands twice, the last one holds.
class Parameters {
 public:
  /// Reads them; the owner, as `Shape "sphere"`, is for sentences. Tokens and notes must outlive
  /// them.
  Parameters(Tokens& tokens, std::string owner, SceneNotes& notes);

  bool has(std::string_view name);
  /// One number; the fallback where there is no such parameter.
  double number(std::string_view name, double fallback);
  /// A whole number from least to most.
  std::int64_t whole(std::string_view name, std::int64_t fallback, std::int64_t least,
                     std::int64_t most);
  Vec3<double> vector(std::string_view name, const Vec3<double>& fallback);
  /// So many numbers, or none where there is no such parameter.
  std::vector<double> numbers(std::string_view name, std::size_t count);
  std::string_view word(std::string_view name, std::string_view fallback);
  /// Three numbers, or one that is grey, none negative; what is a texture, a spectrum or the like
  /// is skipped, with a note.
  Colour colour(std::string_view name, const Colour& fallback);
  /// A colour of no more than 1.
  Colour reflectance(std::string_view name, const Colour& fallback);

  /// They change nothing in the pictures of rayaudit.
  void ignore(std::initializer_list<std::string_view> names);
  /// Names what was not asked for.
  void finish();

  /// Where the parameter stands.
  Place place(std::string_view name) const;
  /// Throws SceneError at the parameter.
  [[noreturn]] void refuse(std::string_view name, const std::string& what) const;
  SceneNotes& notes() { return *notes_; }
  const std::string& owner() const { return owner_; }

 private:
  struct Parameter {
    Token declaration;
    std::string_view type, name;
    std::vector<double> numbers = {};
    std::vector<std::string_view> words = {};
    bool used = false;
  };

  Parameter read(Tokens& tokens) const;
  void read_value(Parameter& parameter, const Token& value) const;
  const Parameter* find(std::string_view name) const;
  const Parameter* ask(std::string_view name);
  void require_numbers(const Parameter& parameter, std::size_t count) const;

  std::string owner_;
  Token begin_;
  SceneNotes* notes_;
  std::vector<Parameter> parameters_;
  std::vector<std::string_view> asked_;
};

}  // namespace rayaudit
