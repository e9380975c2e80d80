#pragma once

#include <string>
#include <string_view>

namespace rayaudit {

/// Any bytes as the content of an XML 1.0 element: marks as entities; what is no UTF-8, or no
/// character that XML has, as \x1b.
std::string xml_text(std::string_view bytes);

/// ` key="..."`; ends of lines and tabs in it are kept too.
std::string xml_attribute(std::string_view key, std::string_view bytes);

}  // namespace rayaudit
