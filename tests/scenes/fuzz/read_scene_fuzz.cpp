#include <cstddef>
#include <cstdint>
#include <string_view>

#include "scenes/read_scene.hpp"

/// Whatever the bytes, they are a scene or an error of one place; both as far as a scene goes on.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace rayaudit;
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  try {
    rounded(read_scene_text(text, "fuzz.pbrt", {}), float_format);
  } catch (const SceneError&) {
    return 0;
  }
  return 0;
}
