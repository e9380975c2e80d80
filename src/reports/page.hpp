#pragma once

#include <string>
#include <string_view>

namespace rayaudit {

/// Was there an npm when this was built? Else there are no pages.
bool has_page();
/// Throws Error that tells how to get one, where has_page() is false.
void require_page();

/// The page around the data of a report, whose key "report" says audit, cost or ladder: one file
/// that needs no network. Nothing in title or json can become markup. Throws as require_page().
std::string page(std::string_view title, std::string_view json);

}  // namespace rayaudit
