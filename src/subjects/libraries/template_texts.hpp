#pragma once

#include <span>
#include <string_view>

namespace rayaudit {

/// A program template as it was when this was compiled.
struct TemplateText {
  std::string_view file, text;
};

/// All of them, by file.
std::span<const TemplateText> template_texts();

}  // namespace rayaudit
