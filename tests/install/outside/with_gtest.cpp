#include <optional>
#include <rayaudit/gtest.hpp>

TEST(Outside, AnAnswerThatHolds) {
  const auto question =
      rayaudit::question_of(rayaudit::ray({0, 0.5, -3}, {0, 0, 1}), rayaudit::sphere({0, 0, 0}, 1));
  EXPECT_TRUE(rayaudit::agrees(question, rayaudit::hit(0x1.112614p+1f), {0.5}));
}

TEST(Outside, AnAnswerThatFails) {
  const auto question = rayaudit::question_of("sphere 0 0 0 1 ray 0 0.5 -3 0 0 1");
  EXPECT_TRUE(rayaudit::agrees(question, std::optional<float>()));
}
