#ifndef RAYAUDIT_BOOST_TEST_HPP
#define RAYAUDIT_BOOST_TEST_HPP

/// BOOST_TEST(rayaudit::agrees(question, answer)) that tells what is wrong.

#include <boost/test/unit_test.hpp>

#include "oracle.hpp"

namespace rayaudit {
inline namespace face {

/// What BOOST_TEST makes of an agreement: what holds, and the text where it does not. For each kind
/// of reference, or Boost's own would be preferred.
inline auto told_to(const boost::test_tools::assertion::seed& seed, const Agreement& agreement) {
  boost::test_tools::assertion_result result(static_cast<bool>(agreement));
  if (!result) result.message() << agreement;
  return seed->*std::move(result);
}
inline auto operator->*(const boost::test_tools::assertion::seed& seed, Agreement&& agreement) {
  return told_to(seed, agreement);
}
inline auto operator->*(const boost::test_tools::assertion::seed& seed, Agreement& agreement) {
  return told_to(seed, agreement);
}
inline auto operator->*(const boost::test_tools::assertion::seed& seed,
                        const Agreement& agreement) {
  return told_to(seed, agreement);
}

}  // namespace face
}  // namespace rayaudit

#endif
