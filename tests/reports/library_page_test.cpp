#include "reports/library_page.hpp"

#include <boost/test/unit_test.hpp>

#include "geometry/case_line.hpp"
#include "reports/contract.hpp"
#include "tests/reports/hand_made.hpp"

using namespace rayaudit;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

/// A run of one library with a sphere that misses a plain hit, and a clean cylinder.
struct OneFinding : HandMade {
  OneFinding() {
    Tally& tally = add("ode/double", 1, "anywhere");
    subjects.back().about = "ODE 0.16";
    subjects.back().format = double_format;
    subjects.back().convention.of(oracle::Kind::rim) = Convention::Stance::hit;
    turn(tally, Verdict::false_miss, Claim::none, 5);
    Outcome& outcome = tally.outcome(Verdict::false_miss, Claim::none);
    outcome.beyond_rounding = 4;
    outcome.worst->beyond_rounding = true;
    outcome.worst->diagnosis = {Cause::formula};
    outcome.worst->question = read_case_line("sphere 0 0 0 1 ray 0 0.5 -3 0 0 2").question;
    outcome.worst->answer = Answer::miss();
    add(4, "anywhere");
  }
};

/// A finding whose example is an answer to a case.
LibraryFinding finding_of(const Subject& subject, std::size_t shape, Verdict verdict, Claim claim,
                          const std::string& line, const Diagnosis& cause = {Cause::formula}) {
  LibraryFinding made;
  made.subject = &subject, made.shape = shape, made.verdict = verdict, made.claim = claim;
  const CaseLine read = read_case_line(line);
  made.example.question = read.question, made.example.answer = *read.answer;
  made.example.diagnosis = cause;
  made.families = {{"behind", 3, 100}}, made.wrong = 3, made.cases = 100;
  return made;
}

const std::string sphere_around = "sphere 0 0 2 3 ray 0 0 0 0 0 1 ";

}  // namespace

BOOST_AUTO_TEST_CASE(the_exact_answer_is_told_with_the_way_to_it) {
  const auto question = [](const std::string& line) { return read_case_line(line).question; };
  const Case sphere = question("sphere 0 0 0 1 ray 0 0.5 -3 0 0 2");
  BOOST_TEST(exact_answer(sphere) == "hit (6 - sqrt(3)) / 4 = 1.0669872981077806766...");
  BOOST_TEST(by_hand(sphere) ==
             "The points o + t d on the sphere have A t^2 + B t + C = 0 with A = 4, B = -12, C = "
             "8.25; B^2 - 4 A C = 12.");
  BOOST_TEST(exact_answer(question("sphere 0 0 0 1 ray 0 2 -3 0 0 2")) == "miss");
  BOOST_TEST(exact_answer(question("disk 0 0 0 0 0 1 1 ray 0 0 -3 0 0 2")) == "hit 3 / 2 = 1.5");
  BOOST_TEST(exact_answer(question("sphere 0 0 0 1 ray 0 1 -3 0 0 1")) ==
             "a touch (tangent), or miss");
  const Case disk = question("disk 0 0 0 0 0 1 1 ray 0.25 0 -3 0 0 2");
  BOOST_TEST(exact_answer(disk, Answer::Form::at) == "hit 3 / 2 = 1.5, at 0.25 0 0");
  const Case slanted = question("sphere 0 0 0 1 ray 0.5 -3 0 0 3 0");
  BOOST_TEST(exact_answer(slanted, Answer::Form::at).ends_with("..., at 0.5 -0.866025404 0"));
  BOOST_TEST(exact_answer(question("cylinder 0 0 -1 0 0 1 1 ray 1 0 -3 0 0 1")) ==
             "the ray lies in the surface: any finite t there, or miss");
  BOOST_TEST(by_hand(question("disk 0 0 0 0 0 1 1 ray 0 0 -3 0 0 2")) ==
             "The plane is met where t (d n) = (c - o) n: t 2 = 3.");
  BOOST_TEST(by_hand(question("cone 0 0 0 2 0 0 1 ray 1 0 -3 0 0 1")) ==
             "The points o + t d on the endless lateral surface have A t^2 + B t + C = 0 with A = "
             "16, B = -96, C = 140; B^2 - 4 A C = 256.");
  BOOST_TEST(by_hand(question("sphere 0 0 0 1 ray 0 0.1 -3 0 0 2")) == "");
}

BOOST_AUTO_TEST_CASE(a_wrong_root_that_is_none_is_told_so) {
  const Subject subject = {"ode/double", double_format, {}};
  const auto said = [&](const std::string& answer) {
    return what(finding_of(subject, 1, Verdict::wrong_root, Claim::behind, sphere_around + answer));
  };
  BOOST_TEST(said("hit 1") ==
             "a hit, but t is no root at all; the nearest is -1: there the line meets it before "
             "the ray begins");
  BOOST_TEST(said("at 0 0 1") == said("hit 1"));
  BOOST_TEST(said("hit -1.001") ==
             "a hit, but another than the first: there the line meets it before the ray begins");
}

BOOST_AUTO_TEST_CASE(the_sentence_is_of_what_is_telling) {
  const auto said = [](const std::string& name, std::size_t shape, const std::string& line,
                       const Diagnosis& cause) {
    const Subject subject = {name, double_format, {}};
    const LibraryFinding finding =
        finding_of(subject, shape, Verdict::false_miss, Claim::none, line, cause);
    return library_program(finding)->sentence;
  };
  const std::string sphere = "sphere 0 0 0 1 ray 0 0 -3 0 0 1 miss";
  const std::string shapes = "geometric_shapes/double", rapier = "npm.rapier/float";
  const Diagnosis of_length = {Cause::assumption, "the length of the direction"};
  const Diagnosis of_size = {Cause::assumption, "the unit of length"};
  BOOST_TEST(contains(said(shapes, 1, sphere, of_length), "Passing dir as a unit vector"));
  BOOST_TEST(contains(said(shapes, 1, sphere, of_size), "Check if a ray intersects the body"));
  BOOST_TEST(contains(said(rapier, 1, sphere, of_size), "`ray.dir.norm() * maxToi`"));
  BOOST_TEST(contains(said(rapier, 1, sphere_around + "miss", of_size), "are hollow"));
}

BOOST_AUTO_TEST_CASE(what_one_case_shows_of_two_subjects_of_a_library_is_told_once) {
  HandMade made;
  made.add("glm/double", 1, "behind"), made.add("glm_position/double", 1, "behind");
  made.add("ode/double", 1, "behind");
  std::vector<LibraryFinding> found;
  for (const Subject& subject : made.subjects)
    found.push_back(
        finding_of(subject, 1, Verdict::false_hit, Claim::none, sphere_around + "hit 9"));
  for (Audit& audit : made.audits) {
    turn(audit.tally, Verdict::false_hit, Claim::none, 3);
    audit.tally.outcome(Verdict::false_hit, Claim::none).beyond_rounding = 3;
  }
  found[1].example.answer = Answer::yes();
  const auto told = told_once(to_be_confirmed(found, {}));
  BOOST_TEST_REQUIRE(told.size() == 2U);
  BOOST_TEST_REQUIRE(told[0].same.size() == 1U);
  const std::string page = write_library_page(made.run(), told);
  for (const std::string part :
       {"| `glm/double` | glm/double | sphere | **1** |",
        "| `glm_position/double` | glm_position/double | sphere | 1 as of `glm/double` |",
        "  - the same of `glm_position/double`: 3 of 100 in behind "
        "([program](programs/glm_position-double.sphere.false_hit.cpp))\n"})
    BOOST_TEST(contains(page, part), part + " in " + page);
  BOOST_TEST(contains(write_tracker(told[0], made.run()), "shows the same of glm_position/double"));
  found[1].verdict = Verdict::wrong_root;
  BOOST_TEST(told_once(to_be_confirmed(found, {})).size() == 3U);
}

BOOST_AUTO_TEST_CASE(a_finding_becomes_a_program_that_says_what_it_asks) {
  const OneFinding made;
  const auto found = library_findings(made.audits);
  BOOST_TEST_REQUIRE(found.size() == 1U);
  const auto shown = to_be_confirmed(found, {});
  BOOST_TEST_REQUIRE(shown.size() == 1U);
  const auto& [program, sentence, worst, library] = shown[0].shown_by;
  BOOST_TEST(program.file == "ode-double.sphere.false_miss.cpp");
  BOOST_TEST(contains(sentence, "ode/collision.h"), sentence);
  for (const std::string line :
       {"// ODE 0.16\n", "// build: c++ ", "\n// case: sphere 0x0p+0 ",
        "\n// exact: hit (6 - sqrt(3)) / 4 = ", "\n// observed: miss\n",
        "\n// wrong by: rayaudit judge --format double --convention rim=hit\n",
        "#include <ode/ode.h>", "0.0, 0.5, -3.0"})
    BOOST_TEST(contains(program.text, line), program.text);
}

BOOST_AUTO_TEST_CASE(the_page_has_what_is_confirmed_and_who_is_clean) {
  OneFinding made;
  const Run run = made.run();
  const auto found = library_findings(made.audits);
  const std::string page = write_library_page(run, to_be_confirmed(found, {}));
  for (const std::string part :
       {"| `ode/double` | ODE 0.16 | sphere | **1** | 1 of 100 | ",
        "| capped_cylinder | clean: 0 of 100, < 3% | 0 of 100 |  |", "\n### `ode/double`, sphere\n",
        "  - but it says: `\"If the geoms intersect",
        "\n- **false miss**: a miss where there is a hit. 4 of 100 in anywhere. Cause: formula.\n",
        "`rayaudit explain --subject ode/double 'sphere ", "  - exact: `hit (6 - sqrt(3)) / 4 = ",
        "  - observed: `miss`\n", "(programs/ode-double.sphere.false_miss.cpp)",
        "(trackers/ode-double.sphere.false_miss.md)"})
    BOOST_TEST(contains(page, part), part + " in " + page);
  const std::string none = write_library_page(run, {});
  BOOST_TEST(contains(none, "| sphere | none confirmed (4 of 100 beyond rounding) |"), none);
  BOOST_TEST(!contains(none, "## Findings"), none);
  made.audits[0].tally.outcome(Verdict::false_miss, Claim::none).beyond_rounding = 5;
  BOOST_TEST(contains(write_library_page(made.run(), to_be_confirmed(found, {})),
                      "| **1**; beyond rounding, but no finding: 1 of 100 |"));
}

BOOST_AUTO_TEST_CASE(what_a_tracker_could_be_told_stands_alone) {
  const OneFinding made;
  const auto found = library_findings(made.audits);
  const std::string text = write_tracker(to_be_confirmed(found, {}).at(0), made.run());
  for (const std::string part :
       {"# ODE 0.16, sphere: false miss\n",
        "prints `miss`; the exact answer is `hit (6 - sqrt(3)) / 4",
        "The documentation says `\"If the geoms intersect", "&& ./a.out\n",
        "```\n#include <ode/ode.h>", "\nBy hand: ", "by family, ",
        "\n- 4 of 100 in anywhere: ", "Built with a compiler; run on a processor."})
    BOOST_TEST(contains(text, part), part + " in " + text);
  BOOST_TEST(!contains(text, "// case:"), text);
}

BOOST_AUTO_TEST_CASE(families_and_shares_are_told_the_most_first) {
  LibraryFinding finding;
  finding.families = {{"far", 50, 100}, {"unit", 2, 100}, {"axis", 1, 100}};
  BOOST_TEST(afflicted(finding, 9) == "50 of 100 in far, 2 of 100 in unit, 1 of 100 in axis");
  BOOST_TEST(afflicted(finding, 1) == "50 of 100 in far, less of 2 more");
  BOOST_TEST(shares({{"formula", 3}}, 3) == "formula");
  BOOST_TEST(shares({{"formula", 3}, {"rounding", 1}}, 4) == "75.0% formula, 25.0% rounding");
}

BOOST_AUTO_TEST_CASE(no_share_of_a_cause_is_rounded_to_all) {
  Contract contract;
  contract.wrong = 3673;
  contract.by_cause[static_cast<std::size_t>(Cause::unknown)] = 3668.2;
  contract.by_cause[static_cast<std::size_t>(Cause::rounding)] = 4.8;
  BOOST_TEST(causes(contract) == "99.9% unknown, 0.13% rounding");
}

BOOST_AUTO_TEST_CASE(times_stand_in_a_file_of_their_own) {
  const OneFinding made;
  Run run = made.run();
  const std::string page = write_library_page(run, {});
  run.times = {{&made.subjects[0], 1, {9, 10, 11}, Spread{4, 5, 6}}};
  BOOST_TEST(write_library_page(run, {}) == page);
  BOOST_TEST(contains(write_library_times(run), "| ode/double | sphere | 10 | 5 | 2 |"));
  BOOST_TEST(contains(write_library_table(run, {}), "  10       2"), write_library_table(run, {}));
}

BOOST_AUTO_TEST_CASE(a_contract_is_told_as_it_was_observed) {
  HandMade made;
  turn(made.add("ode/double", 1, "length"), Verdict::wrong_t, Claim::none, 30);
  turn(made.add(1, "behind"), Verdict::false_hit, Claim::behind, 7);
  turn(made.add(1, "inside"), Verdict::false_miss, Claim::none, 2);
  made.audits.back().tally.touches[1] = {3, 0};
  made.audits.back().tally.touches[2] = {1, 3};
  turn(made.add(1, "invalid"), Verdict::invalid_mishandled, Claim::ended, 5);
  made.audits.back().tally.unasked = 900;
  const auto contracts = contracts_of(made.run());
  BOOST_TEST_REQUIRE(contracts.size() == 1U);
  BOOST_TEST(observed(contracts[0]) ==
             "directions of any length 30 of 100 wrong, 30 of it in t; all behind 7 of 100 wrong, "
             "hits before the start 7 in all; from inside 2 of 100 wrong; tangent hit; rim 25.0% "
             "hit; no case at all: a hit or worse for 5 of 5, its process ended for 5; 900 not "
             "asked, for it crashed or hung too often");
  BOOST_TEST(contracts[0].wrong == 39);
  BOOST_TEST(contracts[0].cases == 395);
}
