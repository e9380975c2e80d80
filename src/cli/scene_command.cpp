#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "cli/command.hpp"
#include "cli/command_text.hpp"
#include "cli/effect_costs.hpp"
#include "cli/exit_code.hpp"
#include "cli/fail_on.hpp"
#include "cli/names.hpp"
#include "cli/option.hpp"
#include "cli/output.hpp"
#include "cli/picture_folder.hpp"
#include "cli/pieces.hpp"
#include "cli/progress_bar.hpp"
#include "cli/renderers.hpp"
#include "cli/report_order.hpp"
#include "cli/stop_signal.hpp"
#include "geometry/case_line.hpp"
#include "geometry/quotation.hpp"
#include "reports/explain_line.hpp"
#include "reports/figures.hpp"
#include "reports/picture_files.hpp"
#include "reports/scene_run.hpp"
#include "scenes/read_scene.hpp"

namespace rayaudit {
namespace {

/// Of a run that was stopped from outside.
constexpr int stopped = 130;

/// What is to fail a picture.
struct SceneFailOn {
  FailOn tallies = {};
  bool self_intersection = false, leak = false;

  bool asks_anything() const { return tallies.asks_anything() || self_intersection || leak; }
};

struct SceneOptions {
  std::string file, pictures, command;  ///< the last: all of this as it was typed
  SubjectChoice subjects;               ///< their names may end in an offset
  std::vector<std::string> reports;
  std::vector<Offset> offsets = {usual_offsets().begin(), usual_offsets().end()};
  std::vector<Effect> effects;  ///< that are left on; empty: all
  SceneFailOn fail_on;
  std::optional<Film> film;
  std::optional<int> samples, bounces;
  std::uint64_t seed = default_seed;
  int threads = 0;
  bool strict = false, explains = false, unaudited = false, thorough = false;
};

SceneFailOn read_scene_fail_on(std::string_view text) {
  SceneFailOn fail_on;
  std::string others;
  for (const std::string_view piece : pieces(text, ','))
    if (piece == "self_intersection") {
      fail_on.self_intersection = true;
    } else if (piece == "leak") {
      fail_on.leak = true;
    } else {
      (others += piece) += ',';
    }
  if (!others.empty() || !fail_on.asks_anything()) fail_on.tallies = read_fail_on(others);
  return fail_on;
}

std::vector<Effect> read_effects(std::string_view text) {
  std::vector<Effect> effects;
  for (const std::string_view piece : pieces(text, ','))
    effects.push_back(static_cast<Effect>(place_of("effect", piece, effect_names)));
  if (effects.empty()) throw Error("--effects: expected an effect, as in --effects primary,shadow");
  return effects;
}

std::vector<Offset> read_offsets(std::string_view text) {
  std::vector<Offset> offsets;
  for (const std::string_view piece : pieces(text, ',')) offsets.push_back(read_offset(piece));
  if (offsets.empty())
    throw Error("--offsets: expected an offset, as in --offsets none,t_min=1e-3");
  return offsets;
}

Film read_film(std::string_view text) {
  const std::size_t x = text.find('x');
  if (x == text.npos)
    throw Error("--film: expected WIDTHxHEIGHT, as in --film 640x480, got " + quotation(text));
  const std::int64_t width = whole_number("--film", text.substr(0, x), 1, most_pixels);
  const std::int64_t height = whole_number("--film", text.substr(x + 1), 1, most_pixels);
  if (width > most_pixels / height)
    throw Error(fmt::format("--film: {} x {} pixels are more than {}", width, height,
                            figures::grouped(static_cast<std::uint64_t>(most_pixels))));
  return {static_cast<int>(width), static_cast<int>(height)};
}

/// A film of another form sees more along its longer side; the form of a pixel stays.
void set_film(Scene& scene, const Film& film) {
  const Film before = std::exchange(scene.film, film);
  if (std::int64_t{film.width} * before.height == std::int64_t{film.height} * before.width) return;
  Camera& camera = scene.camera;
  const double tall = (camera.half_height / before.height) / (camera.half_width / before.width);
  const double width = film.width, height = tall * film.height;
  const double scale = std::min(camera.half_width, camera.half_height) / std::min(width, height);
  camera.half_width = scale * width, camera.half_height = scale * height;
}

Scene scene_of(const SceneOptions& options) {
  Scene scene = read_scene(options.file, options.strict ? Strictness::strict : Strictness::lenient);
  if (options.film) set_film(scene, *options.film);
  scene.samples = options.samples.value_or(scene.samples);
  scene.bounces = options.bounces.value_or(scene.bounces);
  return scene;
}

/// The effects that the scene calls for, but for those that were taken away.
Effects effects_of(const SceneOptions& options, const Scene& scene) {
  if (options.effects.empty()) return effects(scene);
  const auto all = callings(scene);
  for (const Effect effect : options.effects)
    if (const Calling& calling = all[static_cast<std::size_t>(effect)]; !calling.is_on)
      throw Error(fmt::format("--effects: {} calls for no {} rays: {}", scene.name, name(effect),
                              calling.because));
  const auto is_left = [&](Effect effect) {
    return std::find(options.effects.begin(), options.effects.end(), effect) !=
           options.effects.end();
  };
  return {is_left(Effect::shadow), is_left(Effect::reflection), is_left(Effect::refraction)};
}

/// The orders of a picture among several: the files have its name in theirs.
std::vector<ReportOrder> orders_of_one(std::vector<ReportOrder> orders, const Renderer& renderer,
                                       bool is_alone) {
  for (ReportOrder& order : orders) {
    if (is_alone || order.file.empty()) continue;
    const std::filesystem::path file = order.file;
    order.file = (file.parent_path() /
                  (file.stem().string() + "-" + renderer.file_name() + file.extension().string()))
                     .string();
  }
  return orders;
}

/// Throws Error where a report of one of the pictures cannot be written.
void require_all_places(const std::vector<ReportOrder>& orders,
                        const std::vector<Renderer>& renderers) {
  for (const ReportOrder& order : orders)
    if (renderers.size() > 1 && order.file.empty() && scene_reports()[order.report].name != "table")
      throw Error(fmt::format(
          "{} pictures, each with a report: name a file for them, as in --report {}=FILE",
          renderers.size(), scene_reports()[order.report].name));
  for (const Renderer& renderer : renderers)
    require_places(orders_of_one(orders, renderer, renderers.size() == 1));
}

bool is_page(const ReportOrder& order) { return scene_reports()[order.report].name == "html"; }

/// What all pictures of a command line have in common.
struct Studio {
  const SceneOptions& options;
  const Scene& scene;
  Effects effects;
  std::vector<ReportOrder> orders;
  const PictureFolder* folder;  ///< null where no pictures are wanted
  const StopSignal& stop;
  bool is_alone;  ///< is there one picture only?
};

PicturePlan plan_of(const Studio& studio, const Scene& scene, const Renderer& renderer) {
  const SceneOptions& options = studio.options;
  PicturePlan plan = {scene, *renderer.subject, studio.effects, renderer.offset, options.seed};
  plan.threads = renderer.subject->is_elsewhere ? 1 : options.threads;
  plan.audited = !options.unaudited;
  plan.exact = studio.folder != nullptr && !options.unaudited;
  plan.thorough = options.thorough;
  if (plan.audited) plan.offsets = options.offsets;
  return plan;
}

Picture run_with_progress(const PicturePlan& plan, const StopSignal& stop, PictureFiles* files) {
  ProgressBar bar("pixels");
  return run_picture(
      plan,
      [&](const Band& band) {
        if (files != nullptr) files->write(band);
      },
      [&](const Progress& progress) { bar.tell(progress); }, &stop.flag());
}

std::string picture_name(const Scene& scene, const Renderer& renderer) {
  return std::filesystem::path(scene.name).stem().string() + "-" + renderer.file_name();
}

/// The sentence about a wave whose tally or rays break --fail-on; nothing where they hold.
std::optional<std::string> broken(const SceneFailOn& fail_on, const WaveAccount& wave,
                                  const Subject& subject) {
  const auto of_rays = [&](const Trouble& trouble, std::string_view what) {
    // The example has no answer with it: it is asked once more.
    const Worst example = {0, 0, *trouble.example, answer_one(subject, *trouble.example)};
    return fmt::format("{} of {} rays {}: {}", figures::grouped(trouble.count),
                       figures::grouped(wave.rays), what, explain_line(example, subject));
  };
  if (const auto breach = rayaudit::breach(fail_on.tallies, wave.tally))
    return breach->words + ": " + explain_line(*breach->worst, subject);
  if (fail_on.self_intersection && wave.self_intersections.count > 0)
    return of_rays(wave.self_intersections, "meet the surface that they leave at once");
  if (fail_on.leak && wave.leaks.count > 0)
    return of_rays(wave.leaks, "pass between two surfaces that leave no gap");
  return std::nullopt;
}

int told_broken(const SceneFailOn& fail_on, const Renderer& renderer, const Scene& scene,
                const SceneAccount& account) {
  const WaveAccount* first = nullptr;
  std::string sentence;
  int others = 0;
  for (const WaveAccount& wave : account.waves) {
    const auto why = broken(fail_on, wave, *renderer.subject);
    if (!why) continue;
    if (first == nullptr) {
      first = &wave, sentence = *why;
    } else {
      ++others;
    }
  }
  if (first == nullptr) return all_held;
  const std::string more =
      others == 0 ? "" : fmt::format(" ({} more {})", others, others == 1 ? "fails" : "fail");
  complain(fmt::format("--fail-on: {} on {}, {} rays, bounce {}{}: {}", renderer.name(), scene.name,
                       name(first->effect), first->bounce, more, sentence));
  return found;
}

/// A shape that was wrongly left out is rayaudit's own fault, whoever was audited.
int told_culled(const SceneAccount& account) {
  if (account.culling.wrong.count == 0) return all_held;
  complain("rayaudit itself is at fault: a ray was not asked for a shape that it meets: " +
           case_line(*account.culling.wrong.example));
  return unfit;
}

/// Writes the reports of a picture. A page shows its files; the others name those that stay.
void deliver(const Studio& studio, const Renderer& renderer, const SceneRun& run,
             const PictureFiles* files) {
  SceneRun shown = run;
  if (files != nullptr)
    for (std::size_t i = 0; std::string * file : {&shown.picture_file, &shown.exact_file,
                                                  &shown.difference_file, &shown.verdict_file})
      *file = files->path(i++).string();
  const bool stay = !studio.options.pictures.empty();
  for (const bool to_stdout : {false, true})
    for (const ReportOrder& order : orders_of_one(studio.orders, renderer, studio.is_alone))
      rayaudit::deliver({order}, scene_reports(), stay || is_page(order) ? shown : run, {},
                        to_stdout);
}

/// Makes a picture, writes what is asked for of it, and says what breaks --fail-on; the exit code.
int make(const Studio& studio, const Renderer& renderer) {
  const Rounded rounded = rayaudit::rounded(studio.scene, renderer.subject->drawn_in());
  const PicturePlan plan = plan_of(studio, rounded.scene, renderer);
  std::optional<PictureFiles> files;
  if (studio.folder != nullptr)
    files.emplace(studio.folder->path(), picture_name(studio.scene, renderer), plan);
  const Picture picture = run_with_progress(plan, studio.stop, files ? &*files : nullptr);
  if (files) files->close();
  SceneRun run = {RAYAUDIT_VERSION,   plan, picture,       callings(studio.scene),
                  rounded.most_moved, {},   environment(), studio.options.command};
  if (rounded.most_moved > 0)
    run.moved_shape = told(rounded.scene.primitives[rounded.primitive].place);
  deliver(studio, renderer, run, files ? &*files : nullptr);
  return std::max(told_culled(picture.account),
                  told_broken(studio.options.fail_on, renderer, studio.scene, picture.account));
}

int make_all(const Studio& studio, const std::vector<Renderer>& renderers) {
  int code = all_held;
  for (const Renderer& renderer : renderers) {
    code = std::max(code, make(studio, renderer));
    if (!studio.stop.flag()) continue;
    complain("stopped: what was finished is kept");
    return stopped;
  }
  return code;
}

int explain_effects(const SceneOptions& options, const Scene& scene, Effects on,
                    const std::vector<Renderer>& renderers) {
  std::string text;
  for (const Renderer& renderer : renderers)
    (text += text.empty() ? "" : "\n") += effect_costs(scene, renderer, on, options.seed);
  print(text);
  return all_held;
}

/// Whoever cannot answer at all is told before the first picture.
void require_answers(const std::vector<Renderer>& renderers, const Scene& scene) {
  for (const Renderer& renderer : renderers)
    if (renderer.subject->is_elsewhere)
      for (const Primitive& primitive : scene.primitives)
        renderer.subject->answer[primitive.shape.index()]({}, {});
}

int scene(const SceneOptions& options) {
  if (options.unaudited && options.fail_on.asks_anything())
    throw Error("--fail-on needs an audit, and --unaudited makes none");
  const Subjects subjects(options.subjects);
  const Scene scene = scene_of(options);
  const Effects on = effects_of(options, scene);
  const std::vector<Renderer> renderers = rayaudit::renderers(options.subjects, subjects, scene);
  require_answers(renderers, scene);
  if (options.explains) return explain_effects(options, scene, on, renderers);
  const auto orders = orders_of(options.reports, scene_reports());
  require_all_places(orders, renderers);
  std::optional<PictureFolder> folder;
  if (!options.pictures.empty() || std::any_of(orders.begin(), orders.end(), is_page))
    folder.emplace(options.pictures);
  const StopSignal stop;
  return make_all(
      {options, scene, on, orders, folder ? &*folder : nullptr, stop, renderers.size() == 1},
      renderers);
}

void add_names(CLI::App& command, const std::shared_ptr<SceneOptions>& options) {
  command.add_option("FILE", options->file, "a scene, in pbrt's format")->required()->type_name("");
  command
      .add_option("SUBJECT", options->subjects.names,
                  "names or globs, each with an offset after it, as textbook/float@normal")
      ->type_name("");
  add_bringers(command, options->subjects, "without names, only what is brought along traces");
  add_program_format(command, options->subjects);
}

void add_output(CLI::App& command, const std::shared_ptr<SceneOptions>& options) {
  add_option(command, "--pictures", "FOLDER",
             "write the picture, the one with every decision exact, their difference and a map of "
             "verdicts, as they are made",
             [=](const std::string& folder) {
               if (folder.empty()) throw Error("--pictures: expected a folder");
               options->pictures = folder;
             });
  add_list(command, "--report", "FORMAT[=FILE]",
           "table (the default), json or html; may be repeated, but one at most to stdout",
           options->reports);
  add_option(command, "--fail-on", "VERDICT,...",
             "exit 1 where one of these occurs; also max_ulp=N, self_intersection, leak",
             [=](const std::string& text) { options->fail_on = read_scene_fail_on(text); });
  command.add_flag("--explain-effects", options->explains,
                   "only tell which effects are on, because of what, and what each costs");
}

void add_scene(CLI::App& command, const std::shared_ptr<SceneOptions>& options) {
  add_option(command, "--effects", "EFFECT,...",
             "leave on only these of primary, shadow, reflection, refraction",
             [=](const std::string& text) { options->effects = read_effects(text); });
  add_option(command, "--film", "WxH", "pixels, else as the scene says",
             [=](const std::string& text) { options->film = read_film(text); });
  add_number(command, "--samples", "rays through a pixel, else as the scene says", 1, 65'536,
             [=](std::int64_t n) { options->samples = static_cast<int>(n); });
  add_number(command, "--bounces", "at most one after another, else as the scene says", 0, 1'000,
             [=](std::int64_t n) { options->bounces = static_cast<int>(n); });
  command.add_flag("--strict", options->strict, "refuse what is not supported, do not skip it");
}

void add_run(CLI::App& command, const std::shared_ptr<SceneOptions>& options) {
  add_option(command, "--offsets", "OFFSET,...",
             "to compare: none, t_min=T, normal=ULPS, proved; default: the usual ones",
             [=](const std::string& text) { options->offsets = read_offsets(text); });
  command.add_flag("--unaudited", options->unaudited, "the subject's picture alone");
  command.add_flag("--thorough", options->thorough,
                   "all pairs that are culled, and all margins, not those of a share");
  add_seed(command, options->seed);
  add_number(command, "--threads", "else one for each processor; the findings are the same", 1,
             1024, [=](std::int64_t n) { options->threads = static_cast<int>(n); });
}

}  // namespace

void add_scene_command(CLI::App& program, Command& asked) {
  const auto options = std::make_shared<SceneOptions>();
  CLI::App* command = program.add_subcommand(
      "scene", "Trace a scene, hold every ray against the exact truth, and show the harm");
  add_names(*command, options);
  add_output(*command, options);
  add_scene(*command, options);
  add_run(*command, options);
  command->footer(
      "Without names, textbook/float@t_min=1e-4 traces the scene. An offset keeps a ray from\n"
      "meeting the surface that it leaves: none, t_min=T, normal=ULPS along the normal, proved;\n"
      "an offset alone, as @none, is one of textbook/float. Several subjects make a picture and "
      "a\n"
      "report each, with their names in the names of the files. Only the effects that the scene\n"
      "calls for are traced: shadow rays where there is a light, reflection where something\n"
      "mirrors, refraction where something is dielectric. Ctrl-C keeps the rows that are "
      "finished.\n\n"
      "Examples:\n"
      "  rayaudit scene data/scenes/plain.pbrt\n"
      "  rayaudit scene data/scenes/planet.pbrt --pictures planet --report html=planet.html\n"
      "  rayaudit scene planet.pbrt textbook/float@none closest_approach/float@normal --pictures "
      "p\n"
      "  rayaudit scene glass.pbrt --explain-effects\n"
      "  rayaudit scene glass.pbrt --effects primary,shadow --fail-on false_miss,leak\n");
  command->callback([=, &asked] {
    options->command = command_text(*command);
    if (options->reports.empty()) options->reports = {"table"};
    asked = [options] { return scene(*options); };
  });
}

}  // namespace rayaudit
