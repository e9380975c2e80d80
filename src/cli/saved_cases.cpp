#include "cli/saved_cases.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <set>

#include "audit/finding.hpp"
#include "cli/lines.hpp"
#include "cli/report_order.hpp"
#include "cli/truth_words.hpp"
#include "geometry/error.hpp"

namespace rayaudit {
namespace {

/// Keeps other programs from adding to files of the same folder, for as long as it lives. A folder
/// that cannot be locked is not.
class Lock {
 public:
  explicit Lock(const std::string& file)
      : folder_(open(folder_of(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (folder_ >= 0) flock(folder_, LOCK_EX);
  }
  ~Lock() {
    if (folder_ >= 0) close(folder_);
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  static std::string folder_of(const std::string& file) {
    std::error_code fault;
    const auto place = std::filesystem::weakly_canonical(std::filesystem::absolute(file), fault);
    return fault ? "." : place.parent_path().string();
  }

  int folder_;
};

struct CaseFile {
  std::string text;
  std::set<std::string> cases;  ///< as lines of their own
};

CaseFile read_case_file(const std::string& path) {
  CaseFile read;
  std::error_code fault;
  if (!std::filesystem::exists(path, fault)) return read;
  LineFile file(path);
  for (auto pieces = file.next(); !pieces.empty(); pieces = file.next())
    for (const Piece& piece : pieces) {
      read.text += piece.text;
      const ReadPiece held = read_piece(file.name(), piece, Answers::welcome);
      if (held.fault) throw *held.fault;
      for (const Line& line : held.lines)
        if (line.read) read.cases.insert(case_line(line.read->question));
    }
  if (!read.text.empty() && read.text.back() != '\n') read.text += '\n';
  return read;
}

/// `textbook/float: false_hit (parallel), formula: a division by 0; it said hit inf`
std::string reason(const Finding& finding, const Worst& told) {
  std::string said;
  write(said, told.answer);
  const std::string claim =
      finding.claim == Claim::none ? "" : " (" + std::string(name(finding.claim)) + ")";
  const Subject& subject = *finding.audit->subject;
  const bool in_name = subject.name.ends_with('/' + std::string(subject.format.name));
  return fmt::format("{}{}: {}{}, {}; it said {}", subject.name,
                     in_name ? "" : fmt::format(" in {}", subject.format.name),
                     name(finding.verdict), claim, rayaudit::told(told.diagnosis), said);
}

std::string line_of(const Finding& finding, const Worst& told) {
  std::string line = case_line(told.question);
  write_truth(line, told.question, oracle::truth(told.question), double_format);
  return line + " # " + reason(finding, told) + '\n';
}

}  // namespace

void require_case_file(const std::string& file) {
  if (file == "-") throw Error("--save-cases -: expected a file; standard output is a report's");
  read_case_file(file);
}

void save_cases(const std::string& file, const std::vector<Audit>& audits) {
  const Lock lock(file);
  CaseFile saved = read_case_file(file);
  bool any = false;
  for (const Finding& finding : findings(audits)) {
    const Worst told = told_first(finding.example);
    if (!saved.cases.insert(case_line(told.question)).second) continue;
    saved.text += line_of(finding, told);
    any = true;
  }
  if (any) deliver(file, saved.text);
}

}  // namespace rayaudit
