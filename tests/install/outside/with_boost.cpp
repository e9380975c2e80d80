#define BOOST_TEST_MODULE outside
#include <optional>
#include <rayaudit/boost_test.hpp>

BOOST_AUTO_TEST_CASE(an_answer_that_holds) {
  const auto question =
      rayaudit::question_of(rayaudit::ray({0, 0.5, -3}, {0, 0, 1}), rayaudit::sphere({0, 0, 0}, 1));
  BOOST_TEST(rayaudit::agrees(question, rayaudit::hit(0x1.112614p+1f), {0.5}));
}

BOOST_AUTO_TEST_CASE(an_answer_that_fails) {
  const auto question = rayaudit::question_of("sphere 0 0 0 1 ray 0 0.5 -3 0 0 1");
  BOOST_TEST(rayaudit::agrees(question, std::optional<float>()));
}
