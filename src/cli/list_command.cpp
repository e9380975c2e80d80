#include <fmt/format.h>

#include <array>

#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/names.hpp"
#include "cli/option.hpp"
#include "cli/output.hpp"
#include "cli/selection.hpp"
#include "families/family.hpp"
#include "geometry/error.hpp"
#include "reports/declared.hpp"
#include "reports/report.hpp"
#include "subjects/libraries/libraries.hpp"
#include "subjects/subject.hpp"

namespace rayaudit {
namespace {

std::string joined_shapes(const std::vector<std::size_t>& shapes) {
  std::string text;
  for (const std::size_t shape : shapes) (text += text.empty() ? "" : " ") += shape_names[shape];
  return text;
}

template <std::size_t... I>
std::string shape_lines(std::index_sequence<I...>) {
  return (... + fmt::format("{:<17}{}\n", std::variant_alternative_t<I, Shape>::name,
                            std::variant_alternative_t<I, Shape>::about));
}

std::string list_shapes(const Subjects&) {
  return shape_lines(std::make_index_sequence<shape_count>{});
}

/// A row of three columns, of which the last may be empty.
std::string subject_row(std::string_view name, std::string_view shapes, std::string_view words) {
  std::string row = fmt::format("{:<36}{:<54}{}", name, shapes, words);
  return row.erase(row.find_last_not_of(' ') + 1) + '\n';
}

std::string subject_row(const Subject& subject, std::string_view words) {
  std::vector<std::size_t> shapes;
  for (std::size_t shape = 0; shape < shape_count; ++shape)
    if (subject.answers(shape)) shapes.push_back(shape);
  return subject_row(subject.name, joined_shapes(shapes), words);
}

std::string not_here(std::string_view subjects, std::string_view why) {
  return fmt::format("{:<36}not here: {}\n", subjects, why);
}

std::string list_subjects(const Subjects& subjects) {
  std::string text;
  for (const Subject* subject : subjects.all())
    text += subject_row(*subject,
                        subject->by_name_only ? "by name only" : declared(subject->convention));
  for (const Library& library : libraries())
    if (is_here(library))
      text +=
          subject_row(library.subjects, "a library, see rayaudit list libraries", "by name only");
  for (const auto& [names, why] : absent_subjects()) text += not_here(names, why);
  for (const Library& library : libraries())
    if (!is_here(library)) text += not_here(library.subjects, why_absent(library));
  return text;
}

/// What each of its subjects tells of itself; or, in a sentence, why it does not.
std::string list_library(const Library& library) {
  if (!is_here(library)) return not_here(library.subjects, why_absent(library));
  try {
    std::string text;
    for (const Subject& subject : subjects_of(library)) {
      text += subject_row(subject, declared(subject.convention));
      if (!subject.about.empty()) text += "  " + subject.about + '\n';
    }
    return text;
  } catch (const Error& why) {
    return fmt::format("{:<36}{}\n", library.subjects, why.what());
  }
}

std::string list_libraries(const Subjects&) {
  std::string text;
  for (const Library& library : libraries()) text += list_library(library);
  return text;
}

std::string_view name_of(Strength strength) {
  static constexpr std::array<std::string_view, 3> names = {"anywhere", "degenerate", "near"};
  return names[static_cast<std::size_t>(strength)];
}

std::string list_families(const Subjects&) {
  std::string text;
  for (const Family& family : families()) {
    text += fmt::format("{:<15}{:<12}{:<55}{}", family.id, name_of(family.strength),
                        joined_shapes(shapes_of(family)), family.about);
    if (const auto& range = family.difficulty)
      text += fmt::format("; k {} to {} (float {}): {}", range->least, range->most_double,
                          range->most_float, range->about);
    text += '\n';
  }
  return text;
}

std::string list_reports(const Subjects&) {
  std::string text;
  for (const auto& report : reports()) text += fmt::format("{:<10}{}\n", report.name, report.about);
  return text;
}

struct Listing {
  std::string_view heading;
  std::string (*write)(const Subjects& subjects);
  bool is_asked_for = false;  ///< is it left out where nothing is asked for?
};

constexpr std::array listings = {Listing{"shapes", list_shapes}, Listing{"subjects", list_subjects},
                                 Listing{"libraries", list_libraries, true},
                                 Listing{"families", list_families},
                                 Listing{"reports", list_reports}};

int list(const std::string& heading, const SubjectChoice& choice) {
  const Subjects subjects(choice);
  if (!heading.empty()) {
    const auto known = names_of(listings, &Listing::heading);
    print(listings[place_of("list of", heading, known)].write(subjects));
    return all_held;
  }
  std::string text;
  for (const Listing& each : listings) {
    if (each.is_asked_for) continue;
    if (!text.empty()) text += '\n';
    (text += each.heading) += '\n';
    text += each.write(subjects);
  }
  print(text);
  return all_held;
}

}  // namespace

void add_list_command(CLI::App& program, Command& asked) {
  const auto heading = std::make_shared<std::string>();
  const auto choice = std::make_shared<SubjectChoice>();
  CLI::App* command = program.add_subcommand("list", "List what there is to name");
  command
      ->add_option("WHAT", *heading,
                   "shapes, subjects, families or reports, else all four; or libraries, each of "
                   "which is loaded to tell of itself")
      ->type_name("");
  add_bringers(*command, *choice, "what it brings is listed first");
  add_program_format(*command, *choice);
  command->footer(
      "Examples:\n  rayaudit list\n  rayaudit list families\n  rayaudit list libraries\n"
      "  rayaudit list subjects --plugin ./libmine.so\n"
      "  rayaudit list subjects --program 'python3 mine.py' --format float\n");
  command->callback([=, &asked] { asked = [heading, choice] { return list(*heading, *choice); }; });
}

}  // namespace rayaudit
