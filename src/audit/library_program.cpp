#include "audit/library_program.hpp"

#include <string_view>
#include <vector>

#include "audit/transformation.hpp"
#include "geometry/glob.hpp"
#include "subjects/libraries/libraries.hpp"
#include "subjects/libraries/program_templates.hpp"

namespace rayaudit {
namespace {

/// What a program's name is made of, each letter one of a file's name.
std::string plain(std::string_view name) {
  std::string text(name);
  for (char& letter : text)
    if (letter == '/') letter = '-';
  return text;
}

std::string file_of(const LibraryFinding& finding, std::string_view ending) {
  std::string file = plain(finding.subject->name) + '.' + std::string(shape_names[finding.shape]) +
                     '.' + std::string(name(finding.verdict));
  if (finding.is_behind()) file += ".behind";
  return file + std::string(ending);
}

bool begins_inside(const Case& question) {
  const oracle::Truth truth = oracle::truth(question);
  Settled settled(question, truth);
  return comes_from_inside(settled);
}

/// What a failure is known by before its verdict, as the keys of sentences.
std::vector<std::string_view> telling(const LibraryFinding& finding, const Worst& shown) {
  std::vector<std::string_view> keys;
  const auto& [cause, about, turned] = shown.diagnosis;
  if (cause == Cause::assumption && about == length_of_direction) keys.emplace_back("length");
  if (begins_inside(shown.question)) keys.emplace_back("inside");
  if (finding.is_behind()) keys.emplace_back("behind");
  return keys;
}

/// The sentence for a failure: of what is telling, of its verdict, else of any.
std::optional<std::string> sentence_for(const ProgramTemplate& program,
                                        const LibraryFinding& finding, const Worst& shown) {
  for (const std::string_view key : telling(finding, shown))
    for (const Says& says : program.says)
      if (says.key == key) return says.sentence;
  return says_of(program, name(finding.verdict));
}

std::string_view library_of(const Subject& subject) {
  for (const Library& library : libraries())
    if (matches(std::string(library.subjects), subject.name)) return library.plugin;
  return "";
}

}  // namespace

std::optional<LibraryProgram> library_program(const LibraryFinding& finding) {
  const std::string_view subject = finding.subject->name;
  const auto program = program_template(subject.substr(0, subject.rfind('/')), finding.shape);
  if (!program) return {};
  const Worst shown = told_first(finding.example);
  const auto sentence = sentence_for(*program, finding, shown);
  if (!sentence) return {};
  return LibraryProgram{
      {file_of(finding, program->ending()),
       filled(*program, shown.question, finding.subject->format), std::string(program->build)},
      *sentence,
      shown,
      library_of(*finding.subject)};
}

}  // namespace rayaudit
