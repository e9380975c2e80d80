#include <optional>
#include <rayaudit/catch2.hpp>

TEST_CASE("an answer that holds") {
  const auto question =
      rayaudit::question_of(rayaudit::ray({0, 0.5, -3}, {0, 0, 1}), rayaudit::sphere({0, 0, 0}, 1));
  CHECK(rayaudit::agrees(question, rayaudit::hit(0x1.112614p+1f), {0.5}));
}

TEST_CASE("an answer that fails") {
  const auto question = rayaudit::question_of("sphere 0 0 0 1 ray 0 0.5 -3 0 0 1");
  CHECK(rayaudit::agrees(question, std::optional<float>()));
}
