#ifndef RAYAUDIT_GTEST_HPP
#define RAYAUDIT_GTEST_HPP

/// EXPECT_TRUE(rayaudit::agrees(question, answer)) that tells what is wrong.

#include <gtest/gtest.h>

#include "oracle.hpp"

namespace rayaudit {
inline namespace face {

template <>
struct ToldAs<testing::AssertionResult> {
  static testing::AssertionResult of(const Agreement& agreement) {
    if (agreement) return testing::AssertionSuccess();
    return testing::AssertionFailure() << agreement;
  }
};

}  // namespace face
}  // namespace rayaudit

#endif
