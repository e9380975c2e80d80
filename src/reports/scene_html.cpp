#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/error.hpp"
#include "reports/explain_line.hpp"
#include "reports/figures.hpp"
#include "reports/picture_files.hpp"
#include "reports/scene_run.hpp"
#include "reports/scene_words.hpp"
#include "reports/sentence.hpp"
#include "reports/surroundings.hpp"
#include "reports/xml_text.hpp"

namespace rayaudit {
namespace {

using figures::grouped;
using figures::magnitude;
using scenes::counted;

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --paper: #fff; --ink: #1b1b1b; --faint: #5f5f5f; --line: #d9d9d9; --raised: #f5f6f8; --link: #0b5fa5; --bad: #a84a0c; }
@media screen and (prefers-color-scheme: dark) {
  :root { --paper: #141517; --ink: #e8e8e8; --faint: #a5a5a5; --line: #3a3a3a; --raised: #1e2023; --link: #7cbcf0; --bad: #f39a4a; }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, sans-serif; }
main { max-width: 84rem; margin: 0 auto; padding: 1rem; }
h1 { font-size: 1.7rem; margin: 0 0 .25rem; overflow-wrap: anywhere; }
h2 { font-size: 1.3rem; margin: 2.5rem 0 .25rem; }
p { margin: .25rem 0 .75rem; max-width: 60rem; }
a { color: var(--link); }
.about, figcaption, caption { color: var(--faint); font-size: .9rem; }
code { display: block; font: .78rem/1.45 ui-monospace, monospace; overflow-wrap: anywhere; user-select: all; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(max(min(100%, 20rem), 40%), 1fr)); gap: 1.25rem; margin: 1rem 0; align-items: start; }
figure { margin: 0; min-width: 0; scroll-margin-top: .5rem; }
figure img { display: block; width: 100%; height: auto; image-rendering: pixelated; background: #000; cursor: zoom-in; }
figure:target { grid-column: 1 / -1; }
figure:target img { cursor: default; }
figcaption strong { color: var(--ink); }
.back { display: none; float: right; }
figure:target .back { display: inline; }
.legend { display: flex; flex-wrap: wrap; gap: .15rem 1rem; list-style: none; margin: .35rem 0 0; padding: 0; }
.legend i { display: inline-block; width: 1rem; height: .8rem; margin-right: .35rem; border: 1px solid var(--faint); vertical-align: -.05rem; }
.facts { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 17rem), 1fr)); gap: .25rem 1.5rem; margin: 1rem 0; font-size: .9rem; }
.facts div { border-top: 1px solid var(--line); padding-top: .25rem; min-width: 0; }
dt { color: var(--faint); }
dd { margin: 0; overflow-wrap: anywhere; }
.scrolling { overflow-x: auto; }
table { border-collapse: collapse; font-size: .88rem; }
th, td { text-align: left; vertical-align: top; padding: .25rem 1rem .25rem 0; }
thead th { border-bottom: 1px solid var(--faint); vertical-align: bottom; }
tbody tr + tr { border-top: 1px solid var(--line); }
.figure { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.bad { color: var(--bad); font-weight: 600; }
.findings { padding-left: 1.5rem; }
.findings li { margin-bottom: .75rem; }
.cases { margin: .5rem 0; padding: 0; list-style: none; }
.cases li { margin-bottom: .5rem; }
summary { cursor: pointer; }
@media print { main { max-width: none; } figure, li, tr { break-inside: avoid; } h2 { break-after: avoid; } }
)";

/// Text that is markup: all of it is made here, or escaped.
using Markup = std::string;

Markup element(std::string_view tag, const Markup& content) {
  return fmt::format("<{0}>{1}</{0}>\n", tag, content);
}
Markup element(std::string_view tag, std::string_view kind, const Markup& content) {
  return fmt::format("<{0} class=\"{1}\">{2}</{0}>\n", tag, kind, content);
}
Markup paragraph(std::string_view text) { return element("p", xml_text(text)); }
Markup heading(std::string_view text) { return element("h2", xml_text(text)); }

/// The bytes in 64 letters (RFC 4648).
std::string in_letters(std::string_view bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t j = i; j < i + 3; ++j)
      three = three << 8U | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0U);
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t j = 0; j < 4; ++j)
      text += j <= count ? letters[three >> (18U - 6U * j) & 63U] : '=';
  }
  return text;
}

std::string bytes_of(const std::string& file) {
  std::ifstream from(file, std::ios::binary);
  if (!from) throw Error("picture `" + file + "` cannot be read: " + std::strerror(errno));
  return {std::istreambuf_iterator<char>(from), {}};
}

/// A picture that grows to the width of the page when it is clicked.
Markup picture(std::string_view id, const std::string& file, std::string_view name,
               std::string_view about, const SceneRun& run, const Markup& below = "") {
  if (file.empty()) return "";
  const Film& film = run.plan.scene.film;
  return fmt::format(
      R"(<figure id="{0}"><a href="#{0}"><img src="data:image/png;base64,{1}" alt="{2}" width="{3}" height="{4}"></a>
<figcaption><a class="back" href="#pictures">smaller</a><strong>{2}</strong>: {5}{6}</figcaption></figure>
)",
      id, in_letters(bytes_of(file)), xml_text(name), film.width, film.height, xml_text(about),
      below);
}

Markup legend_entry(const PngFile::Pixel& colour, std::string_view meaning) {
  return fmt::format(R"(<li><i style="background:#{:02x}{:02x}{:02x}"></i>{}</li>)", colour.red,
                     colour.green, colour.blue, xml_text(meaning));
}

/// The colours of what there is to be seen.
Markup colours(const SceneRun& run) {
  const WaveAccount all = scenes::sum(run.picture.account);
  Markup entries;
  for (const auto& [verdict, colour] : legend())
    if (verdict == Verdict::right || all.tally.of(verdict) > 0)
      entries += legend_entry(colour, figures::words(name(verdict)));
  if (all.self_intersections.count > 0)
    entries += legend_entry(met_again_colour, "self-intersection, all answers right");
  return element("ul", "legend", entries);
}

Markup pictures(const SceneRun& run) {
  const std::string format(run.plan.subject.format.name);
  const Markup all =
      picture("picture", run.picture_file, run.plan.subject.name, "as its answers make it", run) +
      picture("exact", run.exact_file, "exact",
              "every intersection decided exactly, each t rounded once to " + format +
                  "; points, offset "
                  "and shading as on the left",
              run) +
      picture("difference", run.difference_file, "difference",
              "of the two; black where a screen shows none, else the brighter the larger", run) +
      picture("verdicts", run.verdict_file, "verdicts",
              "of each pixel the worst, of any question that its rays asked", run, colours(run));
  if (all.empty()) return "";
  return fmt::format("<div class=\"pictures\" id=\"pictures\">\n{}</div>\n", all);
}

/// A row of a table: words first, then figures; those that tell of harm stand out.
class Row {
 public:
  Row& words(std::string_view text) {
    cells_ += "<td>" + xml_text(text) + "</td>";
    return *this;
  }
  Row& figure(std::string_view text) {
    cells_ += "<td class=\"figure\">" + xml_text(text) + "</td>";
    return *this;
  }
  Row& count(std::uint64_t count) { return figure(count == 0 ? "-" : grouped(count)); }
  Row& harm(std::uint64_t count) {
    if (count == 0) return figure("-");
    cells_ += "<td class=\"figure bad\">" + grouped(count) + "</td>";
    return *this;
  }
  Markup markup() const { return "<tr>" + cells_ + "</tr>\n"; }

 private:
  Markup cells_;
};

/// A table whose first so many columns are of words.
Markup table(const std::vector<std::string_view>& columns, std::size_t words, const Markup& rows) {
  Markup head;
  for (std::size_t i = 0; i < columns.size(); ++i)
    head +=
        fmt::format("<th{}>{}</th>", i < words ? "" : R"( class="figure")", xml_text(columns[i]));
  return element("div", "scrolling",
                 element("table", element("thead", element("tr", head)) + element("tbody", rows)));
}

Markup facts(const SceneRun& run) {
  const PicturePlan& plan = run.plan;
  Markup all;
  const auto add = [&](std::string_view what, const std::string& text) {
    if (!text.empty())
      all += element("div", element("dt", xml_text(what)) + element("dd", xml_text(text)));
  };
  add("film", fmt::format("{} x {}, {} a pixel", plan.scene.film.width, plan.scene.film.height,
                          counted(static_cast<std::uint64_t>(plan.scene.samples), "sample")));
  add("scene", fmt::format("{}, {}, {} at most", counted(plan.scene.primitives.size(), "shape"),
                           counted(plan.scene.lights.size(), "light"),
                           counted(static_cast<std::uint64_t>(plan.scene.bounces), "bounce")));
  add("subject", fmt::format("{}, works in {}", plan.subject.name, plan.subject.format.name));
  add("offset", plan.offset.name);
  add("seed", std::to_string(plan.seed));
  add("command", run.command);
  add("made by", "rayaudit " + run.version);
  return element("dl", "facts", all);
}

Markup effects(const SceneRun& run) {
  const double time = scenes::sum(run.picture.account).nanoseconds;
  Markup rows;
  for (const scenes::EffectUse& use : scenes::uses(run)) {
    Row row;
    row.words(name(use.calling->effect)).words(scenes::state(use)).words(scenes::reason(use));
    if (run.plan.audited)
      row.count(use.rays);
    else
      row.figure("-");
    row.figure(use.is_on && time > 0 ? fmt::format("{:.0f}%", 100 * use.nanoseconds / time) : "-");
    rows += row.markup();
  }
  return heading("Effects, and what calls for them") +
         table({"effect", "", "because", "rays", "time"}, 3, rows);
}

Markup wave_row(const std::string& name, const WaveAccount& wave,
                const std::vector<Verdict>& verdicts) {
  Row row;
  row.words(name).count(wave.rays).count(wave.questions);
  for (const Verdict verdict : verdicts) row.harm(wave.tally.of(verdict));
  const Worst* widest = wave.tally.widest();
  row.figure(widest == nullptr ? "-" : magnitude(widest->severity));
  row.figure(wave.tally.ulps.count() == 0 ? "-" : magnitude(wave.tally.ulps.largest()));
  return row.harm(wave.self_intersections.count).harm(wave.leaks.count).markup();
}

Markup waves(const SceneAccount& account) {
  const WaveAccount all = scenes::sum(account);
  std::vector<Verdict> verdicts;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < verdict_count; ++i)
    if (const auto verdict = static_cast<Verdict>(i); is_wrong(verdict) && all.tally.of(verdict)) {
      verdicts.push_back(verdict);
      words.push_back(figures::words(name(verdict)));
    }
  std::vector<std::string_view> columns = {"bounce, effect", "rays", "questions"};
  columns.insert(columns.end(), words.begin(), words.end());
  columns.insert(columns.end(),
                 {"largest margin, u", "largest ulp", "self-intersections", "leaks"});
  Markup rows;
  for (const WaveAccount& wave : account.waves)
    rows += wave_row(fmt::format("{} {}", wave.bounce, name(wave.effect)), wave, verdicts);
  if (account.waves.size() > 1) rows += wave_row("all", all, verdicts);
  return heading("By bounce and effect") + table(columns, 1, rows) +
         element("p", "about",
                 "Margin: how far the numbers of a case that is answered wrongly must move for its "
                 "truth to change, in units u of rounding. Ulp: the error of t in units of its "
                 "last place. Self-intersections: rays that meet the surface that they leave where "
                 "they left it. Leaks: rays between two surfaces that leave no gap.");
}

Markup finding(const scenes::Finding& found, const Subject& subject) {
  const Worst& worst = *found.worst;
  return element(
      "li",
      fmt::format("<strong>{}</strong>: {}{}<br>{}", xml_text(figures::words(name(found.verdict))),
                  xml_text(sentence(found.verdict)), xml_text(sentence(found.claim)),
                  xml_text(scenes::where(found))) +
          element("code", xml_text(explain_line(worst, subject))));
}

Markup findings(const SceneRun& run) {
  Markup items;
  for (const scenes::Finding& found : scenes::findings(run.picture.account))
    items += finding(found, run.plan.subject);
  if (items.empty()) return heading("Findings") + paragraph("None.");
  return heading("Findings, worst first") + element("ol", "findings", items);
}

/// What happened, and the command that shows it.
Markup example(std::string_view what, const std::optional<Case>& question, const SceneRun& run) {
  if (!question) return "";
  return element("li", xml_text(what) + element("code", xml_text(scenes::explain_line(
                                                            *question, run.plan.subject))));
}

Markup listed(const Markup& items) { return items.empty() ? "" : element("ul", "cases", items); }

Markup troubles(const SceneRun& run) {
  Markup items;
  for (const WaveAccount& wave : run.picture.account.waves) {
    const std::string where = fmt::format("bounce {}, {}: ", wave.bounce, name(wave.effect));
    items += example(where + counted(wave.self_intersections.count, "self-intersection") +
                         ", the farthest " + magnitude(wave.self_intersections.severity) + " away",
                     wave.self_intersections.example, run) +
             example(where + counted(wave.leaks.count, "leak") + ", the widest missed by " +
                         magnitude(wave.leaks.severity) + " u",
                     wave.leaks.example, run);
  }
  if (items.empty()) return "";
  return heading("Rays that go wrong between surfaces") + listed(items);
}

Markup offset_rows(const SceneAccount& account) {
  Markup rows;
  for (const OffsetAccount& each : account.offsets) {
    Row row;
    row.words(each.offset.name).harm(each.acne.count);
    row.figure(each.acne.count == 0 ? "-" : magnitude(each.acne.severity));
    row.harm(each.lost_contact.count);
    row.figure(each.lost_contact.count == 0 ? "-" : magnitude(each.lost_contact.severity));
    rows += row.markup();
  }
  return table({"offset", "acne", "farthest away", "lost contact", "farthest away"}, 1, rows);
}

Markup offset_cases(const SceneRun& run) {
  const auto& [t_min, ulps, t_min_case, ulps_case, contact, contact_case] =
      run.picture.account.safe;
  Markup items;
  for (const OffsetAccount& each : run.picture.account.offsets)
    items += example(each.offset.name + ", acne", each.acne.example, run) +
             example(each.offset.name + ", lost contact", each.lost_contact.example, run);
  items += example("the departure that takes the largest t_min", t_min_case, run) +
           example("the departure that takes the most ulps", ulps_case, run) +
           example("the nearest contact", contact_case, run);
  if (items.empty()) return "";
  return element("details", element("summary", "The case that shows each") + listed(items));
}

Markup offsets(const SceneRun& run) {
  const SceneAccount& account = run.picture.account;
  const std::string safe = scenes::safe_offset(account);
  if (safe.empty()) return "";
  Markup text = heading("Offsets") + paragraph(safe + '.');
  if (!account.offsets.empty())
    text += element("p", "about", xml_text(scenes::about_offsets(account))) + offset_rows(account);
  return text + offset_cases(run);
}

/// What else there is to say of the shapes and the file.
Markup remarks(const SceneRun& run) {
  Markup text;
  const Culling& culled = run.picture.account.culling;
  if (const std::string culling = scenes::culling(culled); !culling.empty())
    text += heading("Culling") + paragraph(culling + '.') +
            listed(example("culled, though they meet", culled.wrong.example, run));
  if (const std::string moved = scenes::rounding(run); !moved.empty())
    text += heading("Rounding") + paragraph(moved + '.');
  Markup items;
  for (const Skipped& each : run.plan.scene.skipped)
    items += element("li", xml_text(told(each.place) + ": " + each.what));
  if (!items.empty())
    text += heading("Skipped in the file, for there is no use for it") + element("ul", items);
  return text;
}

}  // namespace

std::string write_scene_html(const SceneRun& run, const Look&) {
  const std::string title = run.plan.scene.name + " by " + run.plan.subject.name;
  Markup body = element("h1", xml_text(title)) + paragraph(scenes::summary(run) + '.') +
                pictures(run) + facts(run) + effects(run);
  if (run.plan.audited)
    body += waves(run.picture.account) + findings(run) + troubles(run) + offsets(run);
  body += remarks(run) + element("p", "about", xml_text(surroundings(run.environment)));
  return fmt::format(
      R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src data:">
<link rel="icon" href="data:,">
<title>{}</title>
<style>{}</style>
</head>
<body>
<main>
{}</main>
</body>
</html>
)",
      xml_text(title), style, body);
}

}  // namespace rayaudit
