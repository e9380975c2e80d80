#pragma once

#include <tbb/parallel_for.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "geometry/case_line.hpp"
#include "geometry/error.hpp"

/// Case lines from a file or standard input: read in blocks as large as is there to read, worked on
/// by all cores in pieces, taken back in order.
namespace rayaudit {

/// One line without its end, and the case on it, if one is there.
struct Line {
  std::string_view text;
  std::uint64_t number;  ///< from 1
  std::optional<CaseLine> read;
};

/// Whole lines, the number of the first of them known.
struct Piece {
  std::string_view text;
  std::uint64_t first;
};

/// The lines of a piece up to the first that is wrong, and the sentence about that.
struct ReadPiece {
  std::vector<Line> lines;
  std::optional<Error> fault;
};

enum class Answers { welcome, required };

/// A file, or standard input where the path is empty or `-`.
class LineFile {
 public:
  explicit LineFile(const std::string& path);
  ~LineFile();
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;

  const std::string& name() const { return name_; }

  /// The next whole lines, in pieces, as many as are there to read without waiting, at least one;
  /// none at the end. Their text stands until the next call.
  std::vector<Piece> next();

 private:
  std::size_t read_more();

  std::string name_;
  int descriptor_;
  std::string text_;
  std::size_t used_ = 0;  ///< of the text, by the pieces given out last
  std::uint64_t next_number_ = 1;
};

ReadPiece read_piece(const std::string& file, const Piece& piece, Answers answers);

/// Hands every line to work(span of lines), on all cores, and what it makes of them to take, in
/// order. Throws the Error of the first line that is wrong when all before it is taken.
template <class Work, class Take>
void work_through(LineFile& file, Answers answers, const Work& work, const Take& take) {
  using Made = std::invoke_result_t<const Work&, std::span<const Line>>;
  for (auto pieces = file.next(); !pieces.empty(); pieces = file.next()) {
    std::vector<Made> made(pieces.size());
    std::vector<std::optional<Error>> faults(pieces.size());
    tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
      const ReadPiece read = read_piece(file.name(), pieces[i], answers);
      made[i] = work(read.lines);
      faults[i] = read.fault;
    });
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      take(std::move(made[i]));
      if (faults[i]) throw *faults[i];
    }
  }
}

}  // namespace rayaudit
