#include "subjects/libraries/libraries.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "audit/audit.hpp"
#include "geometry/case_line.hpp"
#include "tests/cli/shell.hpp"
#include "tests/subjects/from_environment.hpp"

/// Libraries as subjects: those that are here, each shape of each by a case worked out by hand; and
/// for all of them what becomes of a plugin that is missing, no plugin, or up to something.
using namespace rayaudit;
using shell::contains;
using shell::Ended;
using shell::refused;

namespace {

/// The program elsewhere, with no library beside it, or with what is planted in Embree's place.
class Elsewhere {
 public:
  explicit Elsewhere(const std::string& embree = "") {
    const std::string program = from_environment("RAYAUDIT");
    folder_.run("mkdir here; ln '" + program + "' here/rayaudit || cp '" + program + "' here");
    if (!embree.empty()) folder_.run("cp '" + embree + "' here/rayaudit-embree.so");
  }

  /// A line in which `there` is the program.
  Ended run(const std::string& line) const {
    return folder_.run("there() { here/rayaudit \"$@\"; }\n" + line);
  }
  void write(const std::string& file, const std::string& text) const { folder_.write(file, text); }

 private:
  shell::Folder folder_;
};

const Elsewhere& planted() {
  static const Elsewhere there(from_environment("planted_library"));
  return there;
}

const std::string absent =
    " is not here: rayaudit-embree.so is not beside the program; it is built where there is Embree "
    "3 (Debian's libembree-dev)";

const std::string few = " --family anywhere --cases 40 --report json";

nlohmann::json first_audit(const Ended& ended) {
  BOOST_TEST_REQUIRE(ended.code == 0, ended);
  return nlohmann::json::parse(ended.out).at("audits").at(0);
}

/// The line of `list libraries` that begins with a word.
std::string line_of(const std::string& text, const std::string& word) {
  const std::size_t at = ("\n" + text).find("\n" + word);
  return at == text.npos ? "" : text.substr(at, text.find('\n', at) - at);
}

/// Those that the project's own tests count on, where they are here.
const std::set<std::string_view> counted_on = {"embree", "glm", "npm", "ode"};

std::vector<Subject> subjects_here() {
  std::vector<Subject> subjects;
  const std::string program = from_environment("RAYAUDIT");
  for (const Library& library : libraries())
    if (counted_on.count(library.plugin) > 0 && is_here(library, program))
      for (Subject& each : subjects_of(library, program)) subjects.push_back(each);
  return subjects;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_library_that_is_not_here_is_told_with_what_it_needs) {
  const Elsewhere bare;
  const auto subjects = bare.run("there list subjects");
  BOOST_TEST(subjects.code == 0);
  for (const Library& library : libraries())
    BOOST_TEST(contains(subjects.out, "\n" + std::string(library.subjects) + ' '), library.plugin);
  const auto listed = bare.run("there list libraries");
  BOOST_TEST(listed.code == 0);
  BOOST_TEST(shell::line_count(listed.out) == libraries().size(), listed);
  BOOST_TEST(line_of(listed.out, "embree*/float").ends_with("not here:" + absent.substr(13)),
             listed);
  for (const std::string name :
       {"embree/float", "'embree/*'", "embree_pick/float", "embree/double"})
    BOOST_TEST(bare.run("there audit " + name) ==
               refused(2, "subject `" + (name[0] == '\'' ? "embree/*" : name) + "`" + absent));
  BOOST_TEST(bare.run("there explain --subject embree/float sphere 0 0 0 1 ray 0 0 -3 0 0 1") ==
             refused(2, "subject `embree/float`" + absent));
  bare.write("rows.txt", "# a comment\nembree/float sphere * wrong 0 observed\n");
  BOOST_TEST(bare.run("there audit textbook/float --bounds rows.txt") ==
             refused(2, "rows.txt:2: subject `embree/float`" + absent));
}

BOOST_AUTO_TEST_CASE(a_library_is_loaded_only_where_it_can_be_meant) {
  const auto quietly = [](const std::string& names) {
    const auto ended = planted().run("FLAW='aborts as it is loaded' there audit " + names +
                                     " --shape sphere" + few);
    return ended.code == 0 && ended.err.empty();
  };
  BOOST_TEST(quietly("textbook/float"));
  BOOST_TEST(quietly("'*/float'"));
  BOOST_TEST(quietly(""));
  BOOST_TEST(!quietly("embree_planted/float"));
  BOOST_TEST(!quietly("'embree*'"));
  BOOST_TEST(!quietly("'em*/float'"));
  BOOST_TEST(planted().run("FLAW='aborts as it is loaded' there list subjects").code == 0);
}

BOOST_AUTO_TEST_CASE(its_subjects_are_audited_by_name_and_by_glob) {
  for (const std::string name :
       {"embree_planted/float", "'embree*'", "'emb*'", "'embree_p*/float'"}) {
    const auto ended = planted().run("there audit " + name + " --shape sphere" + few);
    BOOST_TEST(first_audit(ended).at("subject") == "embree_planted/float", name);
  }
  const auto both = planted().run("there audit 'embree*' textbook/float --shape sphere" + few);
  BOOST_TEST(nlohmann::json::parse(both.out).at("audits").size() == 2);
  const auto unknown = planted().run("there audit embree_plantd/float");
  BOOST_TEST(unknown.code == 2);
  BOOST_TEST(contains(unknown.err, "did you mean `embree_planted/float`?"), unknown);
}

BOOST_AUTO_TEST_CASE(it_tells_itself_what_it_is_and_what_it_declares) {
  const auto listed = planted().run("there list libraries");
  BOOST_TEST(listed.code == 0);
  BOOST_TEST(contains(listed.out,
                      "\nembree_planted/float                sphere cylinder                       "
                      "                ray=segment,extent=unbounded,stand=upright_z\n  Planted "
                      "1.0\n"),
             listed);
  BOOST_TEST(contains(listed.out, "\nglm*/*  "));
  const auto subjects = planted().run("there list subjects");
  BOOST_TEST(line_of(subjects.out, "embree*/float").ends_with("  by name only"), subjects);
}

BOOST_AUTO_TEST_CASE(it_is_asked_as_it_declares_and_what_is_found_is_asked_so_again) {
  const auto ended = planted().run(
      "there audit embree_planted/float --shape cylinder --cases 500 --report json "
      "--report table=table --save-cases found.txt; cat table");
  const auto report = nlohmann::json::parse(ended.out.substr(0, ended.out.find("\n}\n") + 2));
  for (const nlohmann::json& audit : report.at("audits"))
    if (audit.at("family") != "invalid") BOOST_TEST(audit.at("crashed") == 0, audit.at("family"));
  const auto checked = planted().run("there check found.txt --subject embree_planted/float");
  BOOST_TEST(checked.code == 1, checked);
  BOOST_TEST(!contains(checked.out, "posed as"), checked);
  BOOST_TEST(!contains(checked.out, "rounded to"), checked);
  const std::size_t at = ended.out.find("rayaudit explain ", ended.out.find("\n}\n"));
  BOOST_TEST_REQUIRE(at != ended.out.npos, ended);
  const auto shown =
      planted().run("there" + ended.out.substr(at + 8, ended.out.find('\n', at) - at - 8));
  BOOST_TEST(shown.code == 0, shown);
  BOOST_TEST(!contains(shown.out, "embree_planted/float is asked"), shown);
}

BOOST_AUTO_TEST_CASE(bounds_shards_and_explanations_know_its_subjects) {
  planted().write("rows.txt", "embree_planted/float sphere anywhere crashed 0 observed\n");
  const auto held = planted().run("there audit 'embree*' --bounds rows.txt" + few);
  BOOST_TEST(first_audit(held).at("crashed") == 0);
  const auto merged = planted().run(
      "there audit 'embree*' --shape sphere --family anywhere --cases 40 --shard 1/1 --report "
      "shard=all.shard; there merge all.shard --report json");
  BOOST_TEST(first_audit(merged).at("subject") == "embree_planted/float");
  const auto shown =
      planted().run("there explain --subject embree_planted/float sphere 0 0 0 1 ray 0 0 -3 0 0 1");
  BOOST_TEST(contains(shown.out, "\nembree_planted/float         yes "), shown);
}

BOOST_AUTO_TEST_CASE(what_it_does_when_it_is_asked_is_told_and_the_audit_goes_on) {
  const auto with = [](const std::string& flaw) {
    return planted().run("FLAW=" + flaw + " there audit embree_planted/float --shape sphere" + few);
  };
  for (const std::string flaw : {"aborts", "throws"})
    BOOST_TEST(first_audit(with(flaw)).at("crashed") == 16, flaw);
  BOOST_TEST(first_audit(with("hangs")).at("timed_out") > 0);
  const auto printed = with("prints");
  BOOST_TEST(first_audit(printed).at("crashed") == 0);
  BOOST_TEST(!contains(printed.out + printed.err, "printed by"));
}

BOOST_AUTO_TEST_CASE(one_that_cannot_be_loaded_is_told_beside_the_others_and_refused_by_name) {
  const auto told_with = [](const std::string& flaw, const std::string& what) {
    const auto listed = planted().run("FLAW='" + flaw + "' there list libraries");
    BOOST_TEST(listed.code == 0, listed);
    BOOST_TEST(contains(line_of(listed.out, "embree*/float"), "rayaudit-embree.so` " + what),
               listed);
    BOOST_TEST(contains(listed.out, "\nglm*/*  "), listed);
    const auto refusal = planted().run("FLAW='" + flaw + "' there audit embree_planted/float");
    BOOST_TEST(refusal.code == 2, refusal);
    BOOST_TEST(shell::line_count(refusal.err) >= 1);
    BOOST_TEST(contains(refusal.err, "rayaudit-embree.so` " + what), refusal);
  };
  told_with("is of another version", "is of version 7 of rayaudit/plugin.h");
  told_with("aborts as it is loaded", "was killed by SIGABRT while it was loaded");
  told_with("hangs as it is loaded", "");
  told_with("calls itself otherwise",
            "has a subject `other/float`, which is none of `embree*/float`");
  told_with("contradicts itself",
            "has a subject `embree_planted`: its convention has a segment, whose direction is as "
            "long as it is, with a direction of length 1");
  told_with("leans",
            "has a subject `embree_planted`: its convention has an opening that is no radius, but "
            "no stand that is upright");
  told_with("extends further",
            "has a subject `embree_planted`: its convention has 3 for extent, which is no "
            "rayaudit_extent (0, 1 or 2)");
  const Elsewhere text;
  text.write("here/rayaudit-embree.so", "no shared object\n");
  const auto listed = text.run("there list libraries");
  BOOST_TEST(listed.code == 0, listed);
  BOOST_TEST(contains(line_of(listed.out, "embree*/float"), " cannot be loaded: "), listed);
  BOOST_TEST(text.run("there audit embree/float").code == 2);
}

BOOST_AUTO_TEST_CASE(who_takes_no_shape_as_it_stands_traces_no_scene) {
  planted().write("scene.pbrt",
                  "Camera \"perspective\"\nWorldBegin\nShape \"sphere\" \"float radius\" 1\n");
  BOOST_TEST(planted().run("there scene scene.pbrt embree_planted/float") ==
             refused(2,
                     "subject `embree_planted/float` takes no scenes: it declares "
                     "ray=segment,extent=unbounded,stand=upright_z"));
}

BOOST_AUTO_TEST_CASE(what_is_brought_along_by_its_name_is_meant_by_it) {
  const std::string plugin = " --plugin here/rayaudit-embree.so";
  const auto ended =
      planted().run("there audit embree_planted/float --shape sphere" + few + plugin);
  BOOST_TEST(first_audit(ended).at("subject") == "embree_planted/float");
  BOOST_TEST(contains(planted().run("there list subjects --program ./embree --format float").out,
                      "./embree/float "));
}

BOOST_AUTO_TEST_CASE(each_shape_that_a_library_has_is_met_and_missed_where_it_is) {
  const std::pair<std::string, bool> cases[] = {{"0.25 0.125 -4 0 0 1", true},
                                                {"4 4 -4 0 0 1", false},
                                                {"-4 0.25 0.125 1 0 0", true},
                                                {"-4 0.25 4 1 0 0", false}};
  const std::string shapes[] = {"disk 0 0 0 1 0 1 2",
                                "sphere 0 0 0 1",
                                "cylinder 0 0 -1 0 0 1 1",
                                "cone 0 0 -1 0 0 1 1",
                                "capped_cylinder 0 0 -1 0 0 1 1",
                                "capped_cone 0 0 -1 0 0 1 1"};
  for (const Subject& subject : subjects_here()) {
    BOOST_TEST(!subject.about.empty(), subject.name);
    for (const std::string& shape : shapes)
      for (const auto& [ray, _] : cases) {
        const Case drawn = read_case_line(shape + " ray " + ray).question;
        if (!subject.answers(drawn.shape.index())) continue;
        const Case question = asked(drawn, subject.convention, subject.drawn_in());
        const Judgement judgement =
            judge(question, answer_one(subject, question), subject.format, subject.convention);
        BOOST_TEST(!is_wrong(judgement.verdict),
                   subject.name << ": " << name(judgement.verdict) << ": " << case_line(question));
      }
  }
}

BOOST_AUTO_TEST_CASE(a_short_audit_of_a_library_has_every_answer) {
  const std::vector<Subject> subjects = subjects_here();
  Plan plan;
  for (const Subject& each : subjects) plan.subjects.push_back(&each);
  plan.families = {&families().front()};
  for (std::size_t shape = 0; shape < shape_count; ++shape) plan.shapes.push_back(shape);
  plan.cases = 200, plan.seed = 1;
  for (const Audit& audit : run(plan)) {
    const std::string what = audit.subject->name + ' ' + std::string(shape_names[audit.shape]);
    BOOST_TEST(audit.tally.cases == 200, what);
    BOOST_TEST(audit.tally.of(Verdict::crashed) + audit.tally.of(Verdict::timed_out) == 0, what);
    BOOST_TEST(audit.tally.of(Verdict::right) > 100, what);
  }
}
