#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rayaudit {

/// Any bytes as text of GitHub's Markdown, in a table's cell and in HTML within it too: marks as
/// entities, what is no printable ASCII as \x1b.
std::string markdown_text(std::string_view bytes);

/// A line as code within a line, with whatever marks it has; what is no printable ASCII as a space.
/// Not for a cell with a bar.
std::string code_span(std::string_view line);
/// The same line without the code, for where nothing is a mark.
std::string one_line(std::string_view bytes);

/// A text, which ends its last line, as a block of code: nothing in it is a mark.
std::string fenced(std::string_view text);

/// `<details>` that show a block of code below a summary.
std::string folded(std::string_view summary, std::string_view block);

/// What is written of a Markdown report, kept to what GitHub takes for a comment.
class ShortMarkdown {
 public:
  static constexpr std::size_t most = 65'535;

  /// The foot comes last, whatever is left out before it.
  ShortMarkdown(std::string head, std::string foot)
      : text_(std::move(head)), foot_(std::move(foot)) {}

  /// Adds the first pieces, as many as are wanted and fit, the whole then not beyond the limit; and
  /// tells how many are left out: `7 more findings are left out.`
  void add(const std::vector<std::string>& pieces, std::size_t wanted, std::string_view name,
           std::size_t limit = most);
  std::string text() const { return text_ + foot_; }

 private:
  std::string text_, foot_;
};

}  // namespace rayaudit
