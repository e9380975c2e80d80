#ifndef RAYAUDIT_CATCH2_HPP
#define RAYAUDIT_CATCH2_HPP

/// CHECK(rayaudit::agrees(question, answer)) that tells what is wrong. Of Catch2 version 2 or 3.

#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_test_macros.hpp>
#include <catch2/catch_tostring.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include "oracle.hpp"

namespace rayaudit {
inline namespace face {

/// Catch2 breaks lines that are longer, within a number too. Broken at its spaces, a case line
/// reads as before.
inline std::string with_short_lines(std::string text) {
  constexpr std::size_t most = 76;
  std::size_t begin = 0, space = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i - begin > most && space > begin) text[begin = space] = '\n';
    if (text[i] == ' ') space = i;
    if (text[i] == '\n') begin = i;
  }
  return text;
}

}  // namespace face
}  // namespace rayaudit

template <>
struct Catch::StringMaker<rayaudit::Agreement> {
  static std::string convert(const rayaudit::Agreement& agreement) {
    return rayaudit::with_short_lines(agreement.text());
  }
};

#endif
