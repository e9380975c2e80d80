#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "geometry/error.hpp"
#include "reports/picture_files.hpp"
#include "tests/reports/empty_folder.hpp"
#include "tests/reports/hand_made_scene.hpp"

using namespace rayaudit;
using Json = nlohmann::json;

namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The line that begins so, but for spaces; or nothing.
std::string line(const std::string& text, const std::string& begin) {
  std::istringstream lines(text);
  for (std::string each; std::getline(lines, each);) {
    const std::size_t first = each.find_first_not_of(' ');
    if (first != std::string::npos && each.substr(first).starts_with(begin)) return each;
  }
  return "";
}

std::string table(const HandMadeScene& made) { return write_scene_table(made.run(), {}); }
std::string html(const HandMadeScene& made) { return write_scene_html(made.run(), {}); }
Json json(const HandMadeScene& made) { return Json::parse(write_scene_json(made.run(), {})); }

/// A primary wave with everything wrong that there is.
struct Full : HandMadeScene {
  Full() {
    WaveAccount& primary = add(Effect::primary, 0, 1000);
    turn(primary.tally, Verdict::false_hit, Claim::clipped, 12, 0.5, 31.5);
    turn(primary.tally, Verdict::false_miss, Claim::none, 34, 0.25, 4096);
    primary.tally.ulps.add(64);
    primary.tally.worst_ulps = Worst{64, 0, known_case(0.0625), Answer::hit(real(4.5)), {}, {}};
    WaveAccount& shadow = add(Effect::shadow, 0, 2000);
    turn(shadow.tally, Verdict::false_miss, Claim::none, 5, 0.75, 8192);
    turn(shadow.tally, Verdict::crashed, Claim::ended, 3, 0.125, 2);
    shadow.self_intersections = trouble(77, 0.00012, 2);
    shadow.leaks = trouble(8, 1.5, 3);
    SceneAccount& account = picture.account;
    account.offsets = {{{Offset::Kind::none, 0, "none"}, 500, trouble(99, 0.25, 4), {}},
                       {{Offset::Kind::t_min, 1e-3, "t_min=1e-3"}, 500, {}, trouble(6, 0.0009, 5)}};
    account.safe = {0.00025, 13.5, known_case(6), known_case(7), 0.001, known_case(8)};
    account.culling = {111, 222, {}};
  }
};

const std::string here = "ray 0x1p-2 ";  ///< in the line of the known case of 0.25

}  // namespace

BOOST_AUTO_TEST_CASE(there_is_a_table_a_json_and_an_html_that_every_build_can_write) {
  const Full made;
  std::vector<std::string_view> names;
  for (const auto& report : scene_reports()) {
    names.push_back(report.name);
    BOOST_CHECK_NO_THROW(report.require());
    BOOST_TEST(report.write(made.run(), {}).ends_with('\n'), report.name);
  }
  BOOST_TEST((names == std::vector<std::string_view>{"table", "json", "html"}));
}

BOOST_AUTO_TEST_SUITE(tables)

BOOST_AUTO_TEST_CASE(it_says_first_what_was_traced_and_last_what_came_of_it) {
  const std::string text = table(Full());
  BOOST_TEST(text.starts_with(
      "rayaudit 1.2.3: planet.pbrt, 640 x 480, 1 sample a pixel, 1 shape, 1 light; mine/float; "
      "offset t_min=1e-3; seed\n18364758544493064720\n"));
  BOOST_TEST(
      text.ends_with("\n1.80% of 3,000 questions about 3,000 rays answered wrongly; 77 "
                     "self-intersections; 8 leaks\n"));
}

BOOST_AUTO_TEST_CASE(each_effect_is_told_with_what_calls_for_it_its_rays_and_its_time) {
  Full made;
  made.picture.account.waves[0].nanoseconds = 1e6;
  made.picture.account.waves[1].nanoseconds = 3e6;
  const std::string text = table(made);
  BOOST_TEST(line(text, "primary") ==
             "  primary     on          1,000 rays, 25% of the time       every "
             "picture has them");
  BOOST_TEST(line(text, "shadow") ==
             "  shadow      on          2,000 rays, 75% of the time       planet.pbrt:12:1: a "
             "point light shines on a matte sphere");
  BOOST_TEST(has(line(text, "reflection"), "taken away"));
  BOOST_TEST(has(line(text, "reflection"), "planet.pbrt:20:3: a sphere is a mirror"));
  BOOST_TEST(line(text, "refraction") ==
             "  refraction  off                                           nothing is dielectric");
}

BOOST_AUTO_TEST_CASE(each_bounce_and_effect_has_its_row_and_all_have_one) {
  const std::string text = table(Full());
  const auto figures = [&](const std::string& begin) {
    std::istringstream words(line(text, begin));
    std::vector<std::string> all;
    for (std::string word; words >> word;) all.push_back(word);
    return all;
  };
  const auto row = [](const char* words) {
    std::istringstream from(words);
    return std::vector<std::string>(std::istream_iterator<std::string>(from), {});
  };
  BOOST_TEST((figures("0 primary") == row("0 primary 1,000 1,000 12 34 - - - 4.1e3 64 - -")));
  BOOST_TEST((figures("0 shadow") == row("0 shadow 2,000 2,000 - 5 - - - 8.2e3 - 77 8")));
  BOOST_TEST((figures("all ") == row("all 3,000 3,000 12 39 - - - 8.2e3 64 77 8")));
  BOOST_TEST(line(text, "and 3") == "  and 3 crashed");
}

BOOST_AUTO_TEST_CASE(headings_and_figures_end_in_the_same_columns_and_fit_the_page) {
  Full made;
  WaveAccount& large = made.add(Effect::reflection, 12, 123'456'789'012);
  large.self_intersections.count = 12'345'678;
  const std::string text = table(made);
  for (const auto* begin : {"0 primary", "0 shadow", "12 reflection", "all "})
    BOOST_TEST(line(text, begin).size() == line(text, "rays  ").size(), begin);
  std::istringstream lines(text);
  for (std::string each; std::getline(lines, each);)
    BOOST_TEST((each.size() <= 120 || has(each, "rayaudit explain")), each);
}

BOOST_AUTO_TEST_CASE(a_finding_is_told_once_over_all_waves_with_its_worst_case_the_worst_first) {
  const std::string text = table(Full());
  const std::size_t miss = text.find(
      "  1. false miss: a miss where there is a hit\n"
      "     39 answers: 34 of primary rays, 5 of shadow rays; the "
      "worst on a sphere, margin 8.2e3 u, cause: unknown\n"
      "     rayaudit explain --subject mine/float 'sphere 0x0p+0 "
      "0x0p+0 0x1.4p+2 0x1p+0 ray 0x1.8p-1 ");
  BOOST_TEST(miss != text.npos);
  BOOST_TEST(text.find("  2. false hit: ") > miss);
  BOOST_TEST(has(text, "  3. crashed: "));
  BOOST_TEST(!has(text, here));
}

BOOST_AUTO_TEST_CASE(twenty_findings_are_shown_and_all_where_that_is_asked) {
  HandMadeScene made;
  WaveAccount& wave = made.add(Effect::primary, 0, 1000);
  for (const Verdict verdict : {Verdict::false_hit, Verdict::wrong_root})
    for (std::size_t claim = 0; claim < claim_count; ++claim)
      turn(wave.tally, verdict, static_cast<Claim>(claim), 1, 1, 2);
  BOOST_TEST(has(table(made), "\n12 more, less severe: --report json=FILE tells all.\n"));
  const std::string all = write_scene_table(made.run(), {.everything = true});
  BOOST_TEST(has(all, "\n 32. "));
  BOOST_TEST(!has(all, "less severe"));
}

BOOST_AUTO_TEST_CASE(self_intersections_and_leaks_are_told_with_the_worst_case) {
  const std::string text = table(Full());
  BOOST_TEST(has(text,
                 "a ray meets the surface that it leaves, 1.2e-4 away:\n"
                 "    rayaudit explain --subject mine/float 'sphere 0x0p+0 0x0p+0 0x1.4p+2 "
                 "0x1p+0 ray 0x1p+1 "));
  BOOST_TEST(has(text,
                 "a ray passes between two surfaces, missing one by 1.5 u:\n"
                 "    rayaudit explain --subject mine/float 'sphere 0x0p+0 0x0p+0 0x1.4p+2 "
                 "0x1p+0 ray 0x1.8p+1 "));
}

BOOST_AUTO_TEST_CASE(offsets_tell_acne_against_lost_contact_each_with_a_case) {
  const std::string text = table(Full());
  BOOST_TEST(line(text, "none") ==
             "  none                    99            0.25             -               -");
  BOOST_TEST(line(text, "t_min=1e-3") ==
             "  t_min=1e-3               -               -             6          9.0e-4");
  BOOST_TEST(has(text, "none, acne:\n    rayaudit explain"));
  BOOST_TEST(has(text, "t_min=1e-3, lost contact:\n    rayaudit explain"));
  BOOST_TEST(!has(text, "t_min=1e-3, acne"));
}

BOOST_AUTO_TEST_CASE(the_smallest_safe_offset_is_held_against_the_nearest_contact) {
  const auto sentence = [](double t_min, double contact) {
    Full made;
    made.picture.account.safe.t_min = t_min;
    made.picture.account.safe.contact = contact;
    std::string text = table(made);
    std::replace(text.begin(), text.end(), '\n', ' ');
    const std::size_t first = text.find("The smallest safe");
    return text.substr(first, text.find(".  ", first) - first);
  };
  BOOST_TEST(sentence(0.00025, 0.001) ==
             "The smallest safe offset is a t_min above 0.00025 world units, or 13.5 ulps along "
             "the normal, of powers of two; the nearest contact of such a ray lies 0.001 away, 4 "
             "times as far: a t_min between the two is safe here");
  BOOST_TEST(
      sentence(0.5, 0.25).ends_with("lies 0.25 away, within it: no fixed t_min is safe here"));
  BOOST_TEST(
      sentence(0.5, std::numeric_limits<double>::infinity())
          .ends_with("nothing is met but the departure, so that no larger one loses anything"));
}

BOOST_AUTO_TEST_CASE(what_is_safe_is_not_rounded_to_what_is_not) {
  Full made;
  made.picture.account.safe.t_min = 0.00012341;
  made.picture.account.safe.ulps = 16;
  made.picture.account.safe.contact = 0.0012357;
  const std::string text = table(made);
  BOOST_TEST(has(text, "t_min above 0.000124 world units, or 16 ulps"));
  BOOST_TEST(has(text, "0.00123 away"));
}

BOOST_AUTO_TEST_CASE(culling_is_told_with_what_was_settled_and_what_was_wrong) {
  Full made;
  BOOST_TEST(line(table(made), "Culling") ==
             "Culling: 222 pairs of a ray and a shape whose boxes do not meet were settled "
             "exactly: none meets");
  made.picture.account.culling.wrong = trouble(2, 1, 9);
  const std::string text = table(made);
  BOOST_TEST(has(text, "were settled exactly: 2 meet and were wrongly culled\n"));
  BOOST_TEST(has(text, "culled, though they meet:\n    rayaudit explain"));
}

BOOST_AUTO_TEST_CASE(rounding_what_was_skipped_and_the_files_are_told_where_there_are_any) {
  Full made;
  made.skip("planet.pbrt", "Sampler: rays are placed by the seed");
  SceneRun run = made.run();
  run.most_moved = 3e-8;
  run.moved_shape = "planet.pbrt:30:1";
  run.picture_file = "planet.png";
  run.verdict_file = "planet-verdicts.png";
  const std::string text = write_scene_table(run, {});
  BOOST_TEST(has(text, "  planet.pbrt:3:1: Sampler: rays are placed by the seed\n"));
  BOOST_TEST(has(text,
                 "The shapes were rounded to float: a number moved by up to 3.0e-8 of the "
                 "largest in its vector, most of the shape at\nplanet.pbrt:30:1.\n"));
  BOOST_TEST(has(text, "Pictures: planet.png, planet-verdicts.png\n"));
}

BOOST_AUTO_TEST_CASE(what_has_nothing_to_say_is_left_out) {
  HandMadeScene made;
  made.add(Effect::primary, 0, 1000);
  const std::string text = table(made);
  for (const auto* absent : {"Skipped", "Offsets", "smallest safe", "Culling", "rounded to",
                             "Pictures:", "between surfaces", "all  ", "of the time"})
    BOOST_TEST(!has(text, absent), absent);
  BOOST_TEST(has(text, "Findings: none"));
  BOOST_TEST(has(text,
                 "\n0% of 1,000 questions about 1,000 rays answered wrongly; 0 "
                 "self-intersections; 0 leaks\n"));
}

BOOST_AUTO_TEST_CASE(a_picture_that_was_not_audited_or_not_finished_says_so) {
  HandMadeScene made;
  made.add(Effect::primary, 0, 1000);
  BOOST_TEST(has(table(made), "1,000 rays"));
  made.picture.whole = false;
  BOOST_TEST(
      has(table(made), "\nStopped before the end of the picture: of what was finished, 0% "));
  made.plan.audited = false;
  made.picture.whole = true;
  const std::string text = table(made);
  BOOST_TEST(text.ends_with("\nnothing was audited\n"));
  BOOST_TEST(!has(text, "rays "));
  BOOST_TEST(!has(text, "Findings"));
}

BOOST_AUTO_TEST_CASE(there_is_colour_where_it_is_wanted) {
  BOOST_TEST(!has(table(Full()), "\x1b["));
  BOOST_TEST(has(write_scene_table(Full().run(), {.colour = true}), "\x1b[31mfalse miss\x1b[0m"));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(jsons)

BOOST_AUTO_TEST_CASE(it_tells_what_was_traced_how) {
  Full made;
  made.skip("a.pbrt", "a Sampler");
  const Json all = json(made);
  BOOST_TEST(all["schema"] == 1);
  BOOST_TEST(all["report"] == "scene");
  BOOST_TEST(all["tool"]["version"] == "1.2.3");
  BOOST_TEST(all["scene"]["name"] == "planet.pbrt");
  BOOST_TEST(all["scene"]["width"] == 640);
  BOOST_TEST(all["scene"]["shapes"] == 1);
  BOOST_TEST(all["scene"]["skipped"] == Json({{{"place", "a.pbrt:3:1"}, {"what", "a Sampler"}}}));
  BOOST_TEST(all["subject"]["name"] == "mine/float");
  BOOST_TEST(all["subject"]["format"] == "float");
  BOOST_TEST(all["offset"] == "t_min=1e-3");
  BOOST_TEST(all["seed"] == 0xfedcba9876543210);
  BOOST_TEST(all["whole"] == true);
  BOOST_TEST(all["files"]["exact"].is_null());
}

BOOST_AUTO_TEST_CASE(effects_say_whether_they_are_called_for_and_whether_they_are_on) {
  const Json effects = json(Full())["effects"];
  BOOST_TEST(effects[1] == Json({{"effect", "shadow"},
                                 {"called", true},
                                 {"on", true},
                                 {"place", "planet.pbrt:12:1"},
                                 {"because", "a point light shines on a matte sphere"},
                                 {"rays", 2000}}));
  BOOST_TEST(effects[2]["called"] == true);
  BOOST_TEST(effects[2]["on"] == false);
  BOOST_TEST(effects[3]["called"] == false);
  BOOST_TEST(effects[3]["place"].is_null());
}

BOOST_AUTO_TEST_CASE(every_number_of_the_account_is_there_with_its_case) {
  const Json audit = json(Full())["audit"], primary = audit["waves"][0], shadow = audit["waves"][1];
  BOOST_TEST(primary["effect"] == "primary");
  BOOST_TEST(primary["rays"] == 1000);
  BOOST_TEST(primary["right"] == 954);
  BOOST_TEST(primary["false_hit"] == 12);
  BOOST_TEST(primary["wrong"] == 46);
  BOOST_TEST(primary["largest_margin"] == 4096);
  BOOST_TEST(primary["ulp"]["max"] == 64);
  BOOST_TEST(has(primary["worst_ulp"]["case"], "ray 0x1p-4 "));
  BOOST_TEST(has(primary["outcomes"][1]["explain"], here));
  BOOST_TEST(primary["self_intersections"]["count"] == 0);
  BOOST_TEST(primary["self_intersections"]["case"].is_null());
  BOOST_TEST(shadow["self_intersections"]["count"] == 77);
  BOOST_TEST(shadow["self_intersections"]["largest"] == 0.00012);
  BOOST_TEST(has(shadow["leaks"]["explain"], "rayaudit explain --subject mine/float 'sphere"));
  BOOST_TEST(audit["findings"][0]["effects"] == Json({{"primary", 34}, {"shadow", 5}}));
  BOOST_TEST(audit["offsets"][0]["acne"]["count"] == 99);
  BOOST_TEST(audit["offsets"][1]["lost_contact"]["largest"] == 0.0009);
  BOOST_TEST(audit["safe_offset"]["t_min"] == 0.00025);
  BOOST_TEST(audit["safe_offset"]["ulps"] == 13.5);
  BOOST_TEST(audit["safe_offset"]["nearest_contact"] == 0.001);
  BOOST_TEST(has(audit["safe_offset"]["nearest_contact_case"], "ray 0x1p+3 "));
  BOOST_TEST(audit["culling"]["asked"] == 111);
  BOOST_TEST(audit["culling"]["settled"] == 222);
  BOOST_TEST(audit["culling"]["wrong"]["count"] == 0);
}

BOOST_AUTO_TEST_CASE(where_rounded_points_lie_and_how_wrong_grows_with_the_margin_is_there) {
  HandMadeScene made;
  Tally& tally = made.add(Effect::primary, 0, 10).tally;
  tally.sides[static_cast<std::size_t>(Side::beyond)] = 4;
  tally.distance.add(3);
  tally.own.add(0.5);
  tally.curve.add(6, true);
  const Json wave = json(made)["audit"]["waves"][0];
  BOOST_TEST(wave["sides"] == Json({{"beyond", 4}}));
  BOOST_TEST(wave["distance"]["max"] == 3);
  BOOST_TEST(wave["own"]["max"] == 0.5);
  BOOST_TEST(wave["margin_curve"] == Json::parse("[[2, 1, 1]]"));
}

BOOST_AUTO_TEST_CASE(no_time_and_no_command_changes_a_byte) {
  Full made;
  SceneRun run = made.run();
  const std::string before = write_scene_json(run, {});
  for (WaveAccount& wave : made.picture.account.waves) wave.nanoseconds = 123;
  run.command = "rayaudit scene --threads 7";
  BOOST_TEST(write_scene_json(run, {}) == before);
}

BOOST_AUTO_TEST_CASE(what_json_has_no_number_for_is_a_word) {
  Full made;
  made.picture.account.safe.contact = std::numeric_limits<double>::infinity();
  BOOST_TEST(json(made)["audit"]["safe_offset"]["nearest_contact"] == "inf");
}

BOOST_AUTO_TEST_CASE(a_picture_that_was_not_audited_has_no_audit) {
  Full made;
  made.plan.audited = false;
  BOOST_TEST(json(made)["audit"].is_null());
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(pages)

BOOST_AUTO_TEST_CASE(it_is_whole_has_no_script_and_fetches_nothing) {
  const std::string text = html(Full());
  BOOST_TEST(text.starts_with("<!doctype html>\n"));
  BOOST_TEST(text.ends_with("</html>\n"));
  BOOST_TEST(has(text, "default-src 'none'; style-src 'unsafe-inline'; img-src data:\""));
  BOOST_TEST(has(text, "<title>planet.pbrt by mine/float</title>"));
  BOOST_TEST(!has(text, "<script"));
  BOOST_TEST(!has(text, "://"));
}

BOOST_AUTO_TEST_CASE(the_pictures_are_in_it_to_the_byte_each_with_its_name) {
  const EmptyFolder folder("scene_report_test");
  Full made;
  made.scene.film = {1, 1};
  PictureFiles files(folder.path, "one", made.plan);
  files.write({0, 1, {{1, 1, 1}}, {{1, 0, 1}}, {Sight{Verdict::false_hit}}});
  files.close();
  SceneRun run = made.run();
  run.picture_file = files.path(0), run.exact_file = files.path(1);
  run.difference_file = files.path(2), run.verdict_file = files.path(3);
  const std::string text = write_scene_html(run, {});
  // The signature of PNG, the length and name of its first chunk, 1 x 1.
  const std::string head = "<img src=\"data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAAB";
  std::size_t count = 0;
  for (std::size_t at = text.find(head); at != text.npos; at = text.find(head, at + 1)) ++count;
  BOOST_TEST(count == 4u);
  // And the end of each, of four bytes short of a multiple of three or not.
  BOOST_TEST(has(text, "\" alt=\"exact\" width=\"1\" height=\"1\">"));
  for (const auto* id : {"picture", "exact", "difference", "verdicts"})
    BOOST_TEST(has(text, std::string("<figure id=\"") + id + "\"><a href=\"#" + id + "\">"), id);
}

BOOST_AUTO_TEST_CASE(bytes_of_every_length_are_told_in_letters) {
  const EmptyFolder folder("scene_report_letters_test");
  const auto told = [&](std::string_view bytes) {
    HandMadeScene made;
    SceneRun run = made.run();
    run.picture_file = folder.path / "a";
    std::ofstream(run.picture_file, std::ios::binary) << bytes;
    const std::string text = write_scene_html(run, {});
    const std::size_t first = text.find("base64,") + 7;
    return text.substr(first, text.find('"', first) - first);
  };
  // RFC 4648, section 10.
  BOOST_TEST(told("f") == "Zg==");
  BOOST_TEST(told("fo") == "Zm8=");
  BOOST_TEST(told("foo") == "Zm9v");
  BOOST_TEST(told("foobar") == "Zm9vYmFy");
  BOOST_TEST(told(std::string_view("\xff\xef\x00", 3)) == "/+8A");
}

BOOST_AUTO_TEST_CASE(
    a_picture_that_is_not_there_is_an_error_and_one_that_was_not_made_is_left_out) {
  Full made;
  SceneRun run = made.run();
  BOOST_TEST(!has(write_scene_html(run, {}), "<figure"));
  run.exact_file = "/nowhere/exact.png";
  BOOST_CHECK_EXCEPTION(write_scene_html(run, {}), Error, [](const Error& error) {
    return std::string_view(error.what()) ==
           "picture `/nowhere/exact.png` cannot be read: No such file or directory";
  });
}

BOOST_AUTO_TEST_CASE(the_legend_has_what_occurs_and_no_more) {
  const EmptyFolder folder("scene_report_legend_test");
  Full made;
  SceneRun run = made.run();
  run.verdict_file = folder.path / "map.png";
  std::ofstream(run.verdict_file) << "any";
  const std::string text = write_scene_html(run, {});
  BOOST_TEST(has(text, "<i style=\"background:#d55e00\"></i>false hit</li>"));
  BOOST_TEST(has(text, "</i>right</li>"));
  BOOST_TEST(has(text, "</i>crashed</li>"));
  BOOST_TEST(
      has(text, "<i style=\"background:#56b4e9\"></i>self-intersection, all answers right</li>"));
  BOOST_TEST(!has(text, "</i>wrong t</li>"));
}

BOOST_AUTO_TEST_CASE(the_tables_and_cases_are_those_of_the_account) {
  const std::string text = html(Full());
  BOOST_TEST(has(text,
                 "<td>0 shadow</td><td class=\"figure\">2,000</td><td "
                 "class=\"figure\">2,000</td><td class=\"figure\">-</td><td class=\"figure "
                 "bad\">5</td>"));
  BOOST_TEST(has(text, "<strong>false miss</strong>: a miss where there is a hit<br>39 answers: "));
  BOOST_TEST(has(text,
                 "<td>t_min=1e-3</td><td class=\"figure\">-</td><td "
                 "class=\"figure\">-</td><td class=\"figure bad\">6</td>"));
  BOOST_TEST(has(text, "The smallest safe offset is a t_min above 0.00025 world units"));
  BOOST_TEST(has(text, "bounce 0, shadow: 77 self-intersections, the farthest 1.2e-4 away<code>"));
  BOOST_TEST(has(text, "222 pairs of a ray and a shape"));
}

BOOST_AUTO_TEST_CASE(nothing_of_a_file_or_a_name_can_become_markup) {
  Full made;
  const std::string evil = "<b onclick=\"x\">&'";
  made.scene.name = made.subject.name = made.plan.offset.name = evil;
  made.callings[0].because = made.callings[0].place.file = evil;
  made.picture.account.offsets[0].offset.name = evil;
  made.skip(evil, evil);
  SceneRun run = made.run();
  run.command = run.version = run.environment.compiler = evil;
  run.most_moved = 1, run.moved_shape = evil;
  const std::string text = write_scene_html(run, {});
  BOOST_TEST(!has(text, "<b onclick"));
  BOOST_TEST(!has(text, "onclick=\"x"));
  BOOST_TEST(has(text, "&lt;b onclick=&quot;x&quot;&gt;&amp;'"));
}

BOOST_AUTO_TEST_SUITE_END()
