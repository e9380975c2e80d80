#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/shell.hpp"

using nlohmann::json;
using shell::contains;
using shell::Ended;
using shell::Folder;
using shell::refused;

namespace {

const std::string scenes = RAYAUDIT_DATA "/scenes/";

/// A mirror and a glass ball on a floor, under a light: every effect there is.
const std::string every_effect = R"(LookAt 0 -5 2  0 0 0.8  0 0 1
Camera "perspective" "float fov" [45]
Film "image" "integer xresolution" [32] "integer yresolution" [24]
WorldBegin
LightSource "point" "point from" [-3 -4 5] "rgb I" [150 150 150]
Shape "disk" "float radius" [9]
Material "mirror"
Translate -1 0 1
Shape "sphere" "float radius" [0.9]
Material "glass"
Translate 2 0 0
Shape "sphere" "float radius" [0.9]
)";

/// The folder of a test, with that scene in it and one that nothing shines on.
Folder& with_scenes(Folder& folder) {
  folder.write("all.pbrt", every_effect);
  folder.write("dark.pbrt",
               "LookAt 0 -5 2  0 0 0.8  0 0 1\nCamera \"perspective\"\n"
               "Film \"image\" \"integer xresolution\" [32] \"integer yresolution\" [24]\n"
               "WorldBegin\nShape \"sphere\" \"float radius\" [1]\n");
  return folder;
}

Ended run(const std::string& line) {
  Folder folder;
  return with_scenes(folder).run(line);
}

json report_of(const std::string& arguments) {
  const Ended ended = run("rayaudit scene --report json " + arguments);
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(ended.err == "");
  return json::parse(ended.out);
}

/// The effects of rays that were traced, in the order that the report tells them.
std::vector<std::string> traced(const json& report) {
  std::vector<std::string> effects;
  for (const json& wave : report["audit"]["waves"])
    if (std::find(effects.begin(), effects.end(), wave["effect"]) == effects.end())
      effects.push_back(wave["effect"]);
  return effects;
}

std::uint64_t sum_of(const json& report, const std::string& what) {
  std::uint64_t sum = 0;
  for (const json& wave : report["audit"]["waves"]) sum += wave[what].get<std::uint64_t>();
  return sum;
}

/// The words of a picture file's head, as far as a test must know them: is it whole, and how large?
std::string png_size(const std::string& bytes) {
  const bool is_whole = bytes.starts_with("\x89PNG\r\n\x1a\n") && bytes.size() > 33 &&
                        contains(bytes.substr(bytes.size() - 8), "IEND");
  if (!is_whole) return "no picture of " + std::to_string(bytes.size()) + " bytes";
  const auto number = [&](std::size_t at) {
    int n = 0;
    for (std::size_t i = at; i < at + 4; ++i) n = 256 * n + static_cast<unsigned char>(bytes[i]);
    return std::to_string(n);
  };
  return number(16) + " x " + number(20);
}

const std::vector<std::string> ends = {".png", "-exact.png", "-difference.png", "-verdicts.png"};

}  // namespace

BOOST_AUTO_TEST_CASE(a_scene_is_traced_and_told_as_a_table) {
  const Ended ended = run("rayaudit scene all.pbrt");
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(ended.err == "");
  for (const std::string word : {"all.pbrt", "textbook/float", "t_min=1e-4", "primary", "shadow",
                                 "reflection", "refraction"})
    BOOST_TEST(contains(ended.out, word), word << " in " << ended.out);
}

BOOST_AUTO_TEST_CASE(every_scene_of_ours_is_read_whole_and_traced) {
  for (const std::string scene :
       {"plain", "silhouettes", "planet", "tubes", "glass", "cones", "hall"}) {
    const json report = report_of("--strict --film 40x30 " + scenes + scene + ".pbrt");
    BOOST_TEST(report["scene"]["name"] == scene + ".pbrt");
    BOOST_TEST(report["audit"]["waves"][0]["rays"] == 1200);
    BOOST_TEST(report["audit"]["culling"]["wrong"]["count"] == 0);
  }
}

BOOST_AUTO_TEST_CASE(a_scene_without_light_mirror_or_glass_has_primary_rays_only) {
  const std::vector<std::string> primary = {"primary"};
  const json report = report_of("--film 40x30 " + scenes + "silhouettes.pbrt");
  BOOST_TEST(traced(report) == primary, boost::test_tools::per_element());
  BOOST_TEST(report["audit"]["waves"].size() == 1);
}

BOOST_AUTO_TEST_CASE(an_offset_after_a_name_is_the_renderers_own) {
  BOOST_TEST(report_of("dark.pbrt")["offset"] == "t_min=1e-4");
  for (const std::string offset : {"none", "t_min=1e-3", "normal=4", "proved"}) {
    const json report = report_of("dark.pbrt stable_quadratic/double@" + offset);
    BOOST_TEST(report["subject"]["name"] == "stable_quadratic/double");
    BOOST_TEST(report["offset"] == offset);
    BOOST_TEST(report_of("dark.pbrt @" + offset)["offset"] == offset);
    BOOST_TEST(report_of("dark.pbrt @" + offset)["subject"]["name"] == "textbook/float");
  }
}

BOOST_AUTO_TEST_CASE(no_offset_has_acne_and_one_has_none) {
  const json none = report_of("all.pbrt textbook/float@none");
  BOOST_TEST(sum_of(none, "rays") > 1200);
  std::uint64_t met_at_once = 0;
  for (const json& wave : none["audit"]["waves"])
    met_at_once += wave["self_intersections"]["count"].get<std::uint64_t>();
  BOOST_TEST(met_at_once > 0);
  BOOST_TEST(none["audit"]["offsets"].size() == 5);
  BOOST_TEST(none["audit"]["offsets"][0]["acne"]["count"] > 0);
}

BOOST_AUTO_TEST_CASE(the_offsets_to_compare_can_be_chosen) {
  const json report = report_of("all.pbrt --offsets none,t_min=1e-2");
  BOOST_TEST(report["audit"]["offsets"].size() == 2);
  BOOST_TEST(report["audit"]["offsets"][1]["offset"] == "t_min=1e-2");
}

BOOST_AUTO_TEST_CASE(pictures_are_written_where_they_are_asked_for) {
  Folder folder;
  const Ended ended =
      with_scenes(folder).run("rayaudit scene all.pbrt --pictures a/b --report json=a.json");
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(ended.out == "");
  for (const std::string& end : ends)
    BOOST_TEST(png_size(folder.text("a/b/all-textbook-float-t_min=1e-4" + end)) == "32 x 24", end);
  BOOST_TEST(contains(folder.text("a.json"), "a/b/all-textbook-float-t_min=1e-4-exact.png"));
  BOOST_TEST(folder.run("ls a/b | wc -l").out == "4\n");
}

BOOST_AUTO_TEST_CASE(several_subjects_have_pictures_and_reports_of_their_own) {
  Folder folder;
  const Ended ended = with_scenes(folder).run(
      "rayaudit scene dark.pbrt '*/float@none' textbook/double --pictures p --report json=r.json "
      "--report table");
  BOOST_TEST(ended.code == 0, ended);
  for (const std::string each :
       {"textbook-float-none", "certified-float-none", "textbook-double-t_min=1e-4"}) {
    BOOST_TEST(png_size(folder.text("p/dark-" + each + ".png")) == "32 x 24", each);
    BOOST_TEST(json::parse(folder.text("r-" + each + ".json"))["scene"]["name"] == "dark.pbrt");
  }
  BOOST_TEST(contains(ended.out, "textbook/double"));
  BOOST_TEST(run("rayaudit scene dark.pbrt @none @proved --report json") ==
             refused(2,
                     "2 pictures, each with a report: name a file for them, as in --report "
                     "json=FILE"));
}

BOOST_AUTO_TEST_CASE(a_page_shows_pictures_and_leaves_no_files) {
  Folder folder;
  const Ended ended = with_scenes(folder).run(
      "TMPDIR=$PWD rayaudit scene all.pbrt --report html=a.html --report json=a.json && ls");
  BOOST_TEST(ended.out == "a.html\na.json\nall.pbrt\ndark.pbrt\n");
  BOOST_TEST(contains(folder.text("a.html"), "data:image/png;base64,"));
  BOOST_TEST(json::parse(folder.text("a.json"))["files"]["picture"].is_null());
}

BOOST_AUTO_TEST_CASE(any_number_of_threads_gives_the_same_bytes) {
  Folder folder;
  const Ended ended = with_scenes(folder).run(
      "for n in 1 3; do rayaudit scene all.pbrt --film 64x48 --samples 2 --threads $n --pictures p "
      "--report json=report.json || exit; mv p $n; mv report.json $n; done; diff -r 1 3");
  BOOST_TEST(ended == shell::printed(""));
  BOOST_TEST(folder.run("ls 1 | wc -l").out == "5\n");
  const Ended other = folder.run(
      "rayaudit scene all.pbrt --film 64x48 --samples 2 --seed 2 --pictures 2 --report json=r.json"
      "; cmp -s 1/all-textbook-float-t_min=1e-4.png 2/all-textbook-float-t_min=1e-4.png");
  BOOST_TEST(other.code == 1);
}

BOOST_AUTO_TEST_CASE(a_film_of_the_same_form_shows_the_same) {
  Folder folder;
  folder.write("wide.pbrt",
               "Camera \"perspective\" \"float screenwindow\" [-2 2 -1 1]\n"
               "Film \"image\" \"integer xresolution\" 32 \"integer yresolution\" 32\n"
               "WorldBegin\nTranslate 0 0 3\nShape \"sphere\"\nWorldEnd\n");
  const Ended ended = folder.run(
      "for film in '' '--film 32x32' '--film 64x32'; do rayaudit scene wide.pbrt $film --unaudited "
      "--pictures p --report json=r.json; cat p/*.png | cksum; done");
  std::istringstream sums(ended.out);
  std::string of_file, same, other;
  std::getline(sums, of_file), std::getline(sums, same), std::getline(sums, other);
  BOOST_TEST(of_file == same, ended);
  BOOST_TEST(of_file != other, ended);
}

BOOST_AUTO_TEST_CASE(options_override_what_the_scene_says) {
  const json usual = report_of("all.pbrt");
  BOOST_TEST(usual["scene"]["width"] == 32);
  const json other = report_of("all.pbrt --film 20x10 --samples 3 --bounces 1");
  BOOST_TEST(other["scene"]["width"] == 20);
  BOOST_TEST(other["scene"]["height"] == 10);
  BOOST_TEST(other["audit"]["waves"][0]["rays"] == 600);
  for (const json& wave : other["audit"]["waves"]) BOOST_TEST(wave["bounce"] <= 1);
  const std::vector<std::string> two = {"primary", "shadow"};
  BOOST_TEST(traced(report_of("all.pbrt --bounces 0")) == two, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(thorough_settles_every_pair_that_is_culled) {
  const json usual = report_of("all.pbrt"), all = report_of("all.pbrt --thorough");
  BOOST_TEST(usual["audit"]["culling"]["settled"] < all["audit"]["culling"]["settled"]);
}

BOOST_AUTO_TEST_CASE(effects_can_only_be_taken_away) {
  const std::vector<std::string> two = {"primary", "refraction"};
  BOOST_TEST(traced(report_of("all.pbrt --effects refraction")) == two,
             boost::test_tools::per_element());
  BOOST_TEST(run("rayaudit scene dark.pbrt --effects primary,shadow") ==
             refused(2, "--effects: dark.pbrt calls for no shadow rays: no light"));
  BOOST_TEST(run("rayaudit scene all.pbrt --effects shadows") ==
             refused(2, "effect `shadows` is not known; did you mean `shadow`?"));
}

BOOST_AUTO_TEST_CASE(effects_are_explained_by_lines_of_the_file) {
  const Ended ended = run("rayaudit scene all.pbrt --explain-effects --effects shadow,reflection");
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(contains(ended.out, "all.pbrt:5:1: a point light shines on a matte disk"), ended);
  BOOST_TEST(contains(ended.out, "all.pbrt:7:1: a sphere is a mirror"), ended);
  BOOST_TEST(contains(ended.out, "taken away by --effects"), ended);
  BOOST_TEST(contains(run("rayaudit scene dark.pbrt --explain-effects").out, "no light"));
}

BOOST_AUTO_TEST_CASE(many_samples_are_explained_by_fewer_pixels) {
  const Ended ended =
      run("rayaudit scene dark.pbrt --film 640x480 --samples 100 --explain-effects");
  BOOST_TEST(contains(ended.out, "traces it, 32 x 24 pixels"), ended);
  BOOST_TEST(contains(ended.out, "100.00     100"), ended);
}

BOOST_AUTO_TEST_CASE(an_unaudited_picture_is_the_subjects_alone) {
  Folder folder;
  const Ended ended = with_scenes(folder).run(
      "rayaudit scene all.pbrt --unaudited --pictures p --report json=r.json; "
      "rayaudit scene all.pbrt --pictures q --report json=s.json; ls p; "
      "cmp p/all-textbook-float-t_min=1e-4.png q/all-textbook-float-t_min=1e-4.png");
  BOOST_TEST(ended == shell::printed("all-textbook-float-t_min=1e-4.png\n"));
  BOOST_TEST(json::parse(folder.text("r.json"))["audit"].is_null());
  BOOST_TEST(run("rayaudit scene all.pbrt --unaudited --fail-on leak") ==
             refused(2, "--fail-on needs an audit, and --unaudited makes none"));
}

BOOST_AUTO_TEST_CASE(findings_are_no_failure_unless_asked) {
  const Ended held = run("rayaudit scene all.pbrt @none --fail-on crashed,max_ulp=1e300");
  BOOST_TEST(held.code == 0, held);
  const Ended failed = run("rayaudit scene all.pbrt @none --fail-on self_intersection >/dev/null");
  BOOST_TEST(failed.code == 1);
  BOOST_TEST(failed.err.starts_with("rayaudit: --fail-on: textbook/float@none on all.pbrt, "),
             failed);
  BOOST_TEST(contains(failed.err, " meet the surface that they leave at once: rayaudit explain "));
  BOOST_TEST(shell::line_count(failed.err) == 1);
  BOOST_TEST(run("rayaudit scene all.pbrt --fail-on max_ulp=0 >/dev/null").code == 1);
  BOOST_TEST(run("rayaudit scene all.pbrt --fail-on leaks").code == 2);
}

BOOST_AUTO_TEST_CASE(a_subject_that_is_brought_along_traces) {
  const Ended ended =
      run("rayaudit scene dark.pbrt --film 8x6 --report json --format float --program "
          R"("awk '{print \$0, \"miss\"}'")");
  BOOST_TEST(ended.code == 0, ended);
  const json report = json::parse(ended.out);
  BOOST_TEST(report["subject"]["format"] == "float");
  BOOST_TEST(sum_of(report, "false_miss") > 0);
  BOOST_TEST(sum_of(report, "false_hit") == 0);
}

BOOST_AUTO_TEST_CASE(who_does_not_answer_a_shape_of_the_scene_is_refused) {
  const Ended named = run("rayaudit scene dark.pbrt division_free/float");
  BOOST_TEST(named == refused(2,
                              "subject `division_free/float` does not answer the sphere at "
                              "dark.pbrt:5:1"));
  BOOST_TEST(run("rayaudit scene dark.pbrt 'division_free/*'").code == 4);
}

BOOST_AUTO_TEST_CASE(a_mistake_is_one_sentence) {
  Folder folder;
  with_scenes(folder).write("bad.pbrt",
                            "Camera \"perspective\"\nWorldBegin\n"
                            "  Shape \"sphere\" \"float radius\" [0]\n");
  for (const std::string arguments :
       {"", "absent.pbrt", "bad.pbrt", "dark.pbrt textbok/float", "dark.pbrt @t_min=x",
        "dark.pbrt --offsets ,", "dark.pbrt --offsets acne", "dark.pbrt --film 0x0",
        "dark.pbrt --film 640", "dark.pbrt --film 100000x100000", "dark.pbrt --samples 0",
        "dark.pbrt --bounces -1", "dark.pbrt --effects ,", "dark.pbrt --report csv",
        "dark.pbrt --fail-on ''", "dark.pbrt --pictures dark.pbrt", "dark.pbrt --pictures ''",
        "dark.pbrt --report json=/absent/a.json", "dark.pbrt --report table --report json"}) {
    const Ended ended = folder.run("rayaudit scene " + arguments);
    BOOST_TEST(ended.code == 2, arguments << ": " << ended);
    BOOST_TEST(ended.out == "", arguments << ": " << ended);
    BOOST_TEST(ended.err.starts_with("rayaudit: "), arguments << ": " << ended);
    BOOST_TEST(shell::line_count(ended.err) == 1, arguments << ": " << ended);
  }
  BOOST_TEST(contains(folder.run("rayaudit scene bad.pbrt").err, "rayaudit: bad.pbrt:3:"));
}

BOOST_AUTO_TEST_CASE(strict_refuses_what_else_is_skipped) {
  Folder folder;
  with_scenes(folder).write("odd.pbrt", every_effect + "Texture \"a\" \"spectrum\" \"checker\"\n");
  const Ended lenient = folder.run("rayaudit scene odd.pbrt --report json");
  BOOST_TEST(lenient.code == 0);
  BOOST_TEST(json::parse(lenient.out)["scene"]["skipped"].size() == 1);
  const Ended strict = folder.run("rayaudit scene odd.pbrt --strict");
  BOOST_TEST(strict.code == 2);
  BOOST_TEST(strict.err.starts_with("rayaudit: odd.pbrt:13:1: "), strict);
}

BOOST_AUTO_TEST_CASE(a_run_that_is_stopped_keeps_what_is_finished) {
  for (const std::string signal : {"INT", "TERM"}) {
    Folder folder;
    // In a shell without job control what runs in the background ignores SIGINT: so it is made a
    // job of its own.
    const Ended ended = with_scenes(folder).run(
        "set -m; $RAYAUDIT scene all.pbrt --film 640x480 --samples 500 --pictures p --report "
        "json=r.json & sleep 2; kill -" +
        signal + " $!; wait $!; echo $?");
    BOOST_TEST(contains(ended.out, "130\n"), ended);
    BOOST_TEST(contains(ended.err, "rayaudit: stopped: what was finished is kept\n"), ended);
    for (const std::string& end : ends)
      BOOST_TEST(png_size(folder.text("p/all-textbook-float-t_min=1e-4" + end)) == "640 x 480");
    BOOST_TEST(json::parse(folder.text("r.json"))["whole"] == false);
  }
}
