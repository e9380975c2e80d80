#include "reports/page.hpp"

#include "geometry/error.hpp"

// The page as the build has put it together, between two symbols.
asm(".pushsection .rodata\n"
    ".hidden rayaudit_page_begin\n"
    ".hidden rayaudit_page_end\n"
    ".global rayaudit_page_begin\n"
    ".global rayaudit_page_end\n"
    "rayaudit_page_begin:\n"
    ".incbin \"" RAYAUDIT_PAGE
    "\"\n"
    "rayaudit_page_end:\n"
    ".byte 0\n"
    ".popsection\n");
extern "C" const char rayaudit_page_begin[], rayaudit_page_end[];

namespace rayaudit {
namespace {

std::string_view empty_page() {
  return {rayaudit_page_begin, static_cast<std::size_t>(rayaudit_page_end - rayaudit_page_begin)};
}

/// As the text of an element.
std::string escaped(std::string_view text) {
  std::string safe;
  for (const char letter : text) switch (letter) {
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '&':
        safe += "&amp;";
        break;
      default:
        safe += letter;
    }
  return safe;
}

/// The same JSON without a letter that could end a script, or a line in one.
std::string escaped_json(std::string_view json) {
  std::string safe;
  safe.reserve(json.size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::string_view rest = json.substr(i, 3);
    if (rest == "\u2028" || rest == "\u2029") {
      safe += rest == "\u2028" ? "\\u2028" : "\\u2029";
      i += 2;
    } else if (json[i] == '<') {
      safe += "\\u003c";
    } else if (json[i] == '>') {
      safe += "\\u003e";
    } else if (json[i] == '&') {
      safe += "\\u0026";
    } else {
      safe += json[i];
    }
  }
  return safe;
}

}  // namespace

bool has_page() { return !empty_page().empty(); }

void require_page() {
  if (!has_page())
    throw Error("this build has no html reports: install npm, then configure and build again");
}

std::string page(std::string_view title, std::string_view json) {
  require_page();
  constexpr std::string_view title_place = "@TITLE@", report_place = "@REPORT@";
  const std::string_view around = empty_page();
  const std::size_t at = around.find(title_place), then = around.find(report_place);
  std::string text(around.substr(0, at));
  text += escaped(title);
  text += around.substr(at + title_place.size(), then - at - title_place.size());
  text += escaped_json(json);
  return text += around.substr(then + report_place.size());
}

}  // namespace rayaudit
