#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "geometry/answer.hpp"
#include "geometry/case.hpp"
#include "geometry/number_text.hpp"

namespace rayaudit {

/// One case on one line of text, exactly: `sphere cx cy cz r ray ox oy oz dx dy dz [range tmin
/// tmax] [hit t | at x y z | yes | miss | crashed | garbage | timed_out] [# why]`. Numbers are C
/// hex floats or decimals, and inf. After the numbers of a disk, cylinder or cone may stand its
/// extent: `unbounded` or `both_nappes`. The words of a truth are read too: in front of the answer
/// any number of `touch KIND t` and `touch within t t`, which are passed over; in its place
/// `invalid WHY`, a refusal of the case, which is the answer miss.
struct CaseLine {
  Case question;
  std::optional<Answer> answer;
  std::string_view why;    ///< the text after '#', trimmed; points into the line that was read
  std::string_view words;  ///< of the case alone, as they stand; points into the line
};

/// Reads a case line; throws Error that tells what was expected and what stood there.
CaseLine read_case_line(std::string_view line);

/// Is there nothing to read on this line (blank, or only a comment)?
bool is_blank(std::string_view line);

/// Where the comment of a line begins, or its size: what is appended goes in front of it.
std::size_t comment_start(std::string_view line);

/// Append the words of a case or an answer to a line, exactly, in hex floats; no space before or
/// after.
void write(std::string& line, const Case& question);
void write(std::string& line, const Answer& answer);

/// The case as one line, without an end of line.
std::string case_line(const Case& question);

}  // namespace rayaudit
