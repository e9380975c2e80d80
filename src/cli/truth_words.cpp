#include "cli/truth_words.hpp"

#include "geometry/case_line.hpp"

namespace rayaudit {
namespace {

using oracle::Crossing;
using oracle::Kind;
using oracle::Truth;

/// Writes the t of a crossing, or where its stretch ends, correctly rounded.
using WriteT = void (*)(std::string& line, const Case& question, const Crossing& crossing,
                        bool last);

template <class N>
void write_t(std::string& line, const Case& question, const Crossing& crossing, bool last) {
  line += ' ';
  write(line, real(last ? oracle::rounded_last<N>(question, crossing)
                        : oracle::rounded<N>(question, crossing)));
}

WriteT write_t_in(const Format& format) {
  if (format == float_format) return write_t<float>;
  return format == double_format ? write_t<double> : write_t<long double>;
}

}  // namespace

void write_truth(std::string& line, const Case& question, const Truth& truth,
                 const Format& format) {
  const WriteT write_t = write_t_in(format);
  if (truth.invalid != oracle::Invalid::no) {
    (line += " invalid ") += name(truth.invalid);
    return;
  }
  for (const Crossing& crossing : truth.crossings()) {
    if (crossing.kind == Kind::proper) {
      line += " hit";
    } else {
      (line += " touch ") += name(crossing.kind);
    }
    write_t(line, question, crossing, false);
    if (crossing.kind == Kind::within) write_t(line, question, crossing, true);
  }
  if (truth.hit() == nullptr) line += " miss";
}

}  // namespace rayaudit
