#include <cstdio>
#include <string_view>

#include "by_hand.hpp"

/// Traces a scene that calls for no effect, or with `light` one in a light, for callgrind to count.
int main(int count, char** words) {
  using namespace rayaudit;
  Scene scene = by_hand::plain(64, 48);
  if (count < 2 || std::string_view(words[1]) != "light") scene.lights.clear();
  const Subject& textbook = by_hand::subject("textbook/float");
  double sum = 0;
  for (const Colour& colour : by_hand::picture({scene, textbook, effects(scene), {}}))
    sum += colour.x + colour.y + colour.z;
  std::printf("%.17g\n", sum);
}
