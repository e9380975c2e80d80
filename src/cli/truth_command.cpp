#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/formats.hpp"
#include "cli/lines.hpp"
#include "cli/option.hpp"
#include "cli/output.hpp"
#include "cli/truth_words.hpp"

namespace rayaudit {
namespace {

struct TruthOptions {
  std::string file;
  Format format = double_format;
};

std::string truths_of(std::span<const Line> lines, const Format& format) {
  std::vector<Case> cases;
  for (const Line& line : lines)
    if (line.read) cases.push_back(line.read->question);
  std::vector<oracle::Truth> truths(cases.size());
  oracle::truth(cases, truths, oracle::bits_for(format));
  std::string text;
  std::size_t place = 0;
  for (const Line& line : lines) {
    if (line.read) {
      text += line.read->words;
      write_truth(text, cases[place], truths[place], format);
      ++place;
      const std::string_view comment = line.text.substr(comment_start(line.text));
      if (!comment.empty()) (text += ' ') += comment;
    } else {
      text += line.text;
    }
    text += '\n';
  }
  return text;
}

int tell_truths(const TruthOptions& options) {
  LineFile file(options.file);
  work_through(
      file, Answers::welcome,
      [&](std::span<const Line> lines) { return truths_of(lines, options.format); }, print);
  return all_held;
}

}  // namespace

void add_truth_command(CLI::App& program, Command& asked) {
  const auto options = std::make_shared<TruthOptions>();
  CLI::App* command = program.add_subcommand("truth", "Append the exact truth to case lines");
  command->add_option("FILE", options->file, "case lines; standard input where there is none")
      ->type_name("");
  add_option(*command, "--format", "FORMAT",
             "what t is rounded to, correctly: float, double or long_double",
             [=](const std::string& text) { options->format = known_format(text); })
      ->default_str("double");
  command->footer(
      "What is appended, in front of any # comment:\n"
      "  touch KIND t ...  crossings that a small change could lose, up to the first proper one\n"
      "  hit t             the first proper crossing, or\n"
      "  miss              where there is none\n"
      "  invalid WHY       where the case is no question of truth\n"
      "An answer or a truth on the line gives way to it. A line in, a line out.\n\n"
      "Examples:\n"
      "  echo sphere 0 0 0 1 ray 0 0 -3 0 0 1 | rayaudit truth\n"
      "  rayaudit draw --shape cone --family apex --count 5 | rayaudit truth --format float\n");
  command->callback([=, &asked] { asked = [options] { return tell_truths(*options); }; });
}

}  // namespace rayaudit
