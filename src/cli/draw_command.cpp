#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/formats.hpp"
#include "cli/names.hpp"
#include "cli/option.hpp"
#include "cli/output.hpp"
#include "cli/selection.hpp"
#include "families/family.hpp"
#include "geometry/case_line.hpp"
#include "geometry/error.hpp"

namespace rayaudit {
namespace {

struct DrawOptions {
  std::size_t shape = 0;
  const Family* family = nullptr;
  std::uint64_t count = 0;
  std::uint64_t seed = default_seed;
  Format format = double_format;
  std::optional<int> difficulty;
};

void require_drawable(const DrawOptions& options) {
  const Family& family = *options.family;
  if (options.format == long_double_format)
    throw Error("cases are drawn in float or double: no case holds a long_double");
  if (family.draw[options.shape] == nullptr) {
    std::string drawn;
    for (const std::size_t shape : shapes_of(family))
      drawn += (drawn.empty() ? "`" : ", `") + std::string(shape_names[shape]) + "`";
    throw Error(fmt::format("family `{}` does not draw the shape `{}`; it draws {}", family.id,
                            shape_names[options.shape], drawn));
  }
  if (!options.difficulty) return;
  if (!family.difficulty) throw Error("family `" + std::string(family.id) + "` has no difficulty");
  require_difficulty(family, options.format, *options.difficulty);
}

std::string drawn_chunk(const DrawOptions& options, std::uint64_t chunk) {
  std::vector<Case> cases(
      std::min<std::uint64_t>(chunk_cases, options.count - chunk * chunk_cases));
  draw(*options.family, options.shape, options.format, options.difficulty, options.seed, chunk,
       cases);
  std::string text;
  for (const Case& question : cases) {
    write(text, question);
    text += '\n';
  }
  return text;
}

int draw_cases(const DrawOptions& options) {
  constexpr std::uint64_t at_once = 16;
  require_drawable(options);
  const std::uint64_t chunks = (options.count + chunk_cases - 1) / chunk_cases;
  for (std::uint64_t first = 0; first < chunks; first += at_once) {
    std::vector<std::string> texts(std::min(at_once, chunks - first));
    tbb::parallel_for(std::size_t{0}, texts.size(),
                      [&](std::size_t i) { texts[i] = drawn_chunk(options, first + i); });
    for (const std::string& text : texts) print(text);
  }
  return all_held;
}

}  // namespace

void add_draw_command(CLI::App& program, Command& asked) {
  const auto options = std::make_shared<DrawOptions>();
  CLI::App* command = program.add_subcommand("draw", "Draw cases of a family, one a line");
  add_option(
      *command, "--shape", "SHAPE", "see `rayaudit list shapes`",
      [=](const std::string& text) { options->shape = place_of("shape", text, shape_names); })
      ->required();
  add_option(*command, "--family", "FAMILY", "see `rayaudit list families`",
             [=](const std::string& text) {
               options->family =
                   &families()[place_of("family", text, names_of(families(), &Family::id))];
             })
      ->required();
  add_number(*command, "--count", "how many", 1, largest_cases, [=](std::int64_t n) {
    options->count = static_cast<std::uint64_t>(n);
  })->required();
  add_seed(*command, options->seed);
  add_option(*command, "--format", "FORMAT", "every number is one of it: float or double",
             [=](const std::string& text) { options->format = known_format(text); })
      ->default_str("double");
  add_number(
      *command, "--difficulty",
      "draw at difficulty K (see rayaudit list families); default: spread over the family's range",
      INT32_MIN, INT32_MAX, [=](std::int64_t n) { options->difficulty = static_cast<int>(n); })
      ->type_name("K");
  command->footer(
      "These are the very cases that `rayaudit audit` of the same seed puts to its subjects.\n\n"
      "Examples:\n"
      "  rayaudit draw --shape sphere --family grazing --count 10\n"
      "  rayaudit draw --shape cone --family rim --count 1e6 --format float | ./mine |\n"
      "    rayaudit judge --format float\n");
  command->callback([=, &asked] { asked = [options] { return draw_cases(*options); }; });
}

}  // namespace rayaudit
