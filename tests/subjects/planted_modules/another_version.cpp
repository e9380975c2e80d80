#include "subjects/module.hpp"

extern "C" [[gnu::visibility("default")]] const rayaudit::Module* rayaudit_module() {
  using namespace rayaudit;
  static constexpr Module module = {module_version + 1, sizeof(Case), sizeof(Answer), 0, nullptr};
  return &module;
}
