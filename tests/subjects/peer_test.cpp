#include "subjects/peer.hpp"

#include <boost/test/unit_test.hpp>

#include "audit/judge.hpp"
#include "families/family.hpp"
#include "geometry/case_line.hpp"

using namespace rayaudit;

namespace {

Peer by_textbook(const std::string& line, const Format& format = double_format) {
  return rayaudit::by_textbook(read_case_line(line).question, format);
}

double t_of(const Peer& peer) {
  BOOST_TEST_REQUIRE((peer.answer.form == Answer::Form::hit));
  return nearest<double>(peer.answer.t);
}

}  // namespace

BOOST_AUTO_TEST_CASE(it_answers_surely_where_rounding_decides_nothing) {
  const Peer plain = by_textbook("sphere 0 0 0 1 ray 0 0.5 -3 0 0 2");
  BOOST_TEST(plain.is_sure);
  BOOST_TEST(t_of(plain) == (3 - std::sqrt(0.75)) / 2, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(plain.bound < 1e-11);
  const std::string far = "sphere 0 0 0 1 ray 0.1 0.3 -0x1.8p+40 0 0 1";
  BOOST_TEST(!by_textbook(far, float_format).is_sure);
}

BOOST_AUTO_TEST_CASE(it_works_in_the_format_that_it_is_asked_in) {
  const std::string line = "sphere 0 0 0 1 ray 0 0.999999 -3 0 0 1";
  BOOST_TEST(by_textbook(line).is_sure);
  BOOST_TEST(by_textbook(line).bound < by_textbook(line, float_format).bound);
}

BOOST_AUTO_TEST_CASE(shapes_without_ends_go_on) {
  BOOST_TEST(t_of(by_textbook("disk 0 0 0 0 0 1 1 unbounded ray 9 9 -3 0 0 1")) == 3);
  BOOST_TEST(t_of(by_textbook("cylinder 0 0 -1 0 0 1 1 unbounded ray -3 0 8 1 0 0")) == 2);
  BOOST_TEST(t_of(by_textbook("cone 0 0 -1 0 0 1 1 unbounded ray -9 0 -5 1 0 0")) == 6);
  BOOST_TEST(t_of(by_textbook("cone 0 0 -1 0 0 1 1 both_nappes ray -9 0 3 1 0 0")) == 8);
  for (const std::string missed :
       {"disk 0 0 0 0 0 1 1 ray 9 9 -3 0 0 1", "cylinder 0 0 -1 0 0 1 1 ray -3 0 8 1 0 0",
        "cone 0 0 -1 0 0 1 1 unbounded ray -9 0 3 1 0 0"})
    BOOST_TEST((by_textbook(missed).answer.form == Answer::Form::miss), missed);
}

BOOST_AUTO_TEST_CASE(what_it_is_sure_of_shapes_without_ends_is_true) {
  std::vector<Case> cases(chunk_cases);
  std::size_t sure = 0;
  for (const Family& family : families())
    for (std::size_t shape = 0; shape < shape_count; ++shape) {
      if (family.draw[shape] == nullptr || family.id == "invalid") continue;
      draw(family, shape, double_format, {}, 1, 0, cases);
      for (Case& question : cases) {
        question.extent = shape % 2 == 0 ? Extent::unbounded : Extent::both_nappes;
        const Peer peer = rayaudit::by_textbook(question, double_format);
        if (!peer.is_sure) continue;
        ++sure;
        const Judgement judgement = judge(question, peer.answer, double_format);
        // Of what t is the bound tells; a verdict must be right.
        if (judgement.verdict != Verdict::wrong_t)
          BOOST_TEST(!is_wrong(judgement.verdict), case_line(question));
      }
    }
  BOOST_TEST(sure > 30'000);
}
