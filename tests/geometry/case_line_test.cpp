#include "geometry/case_line.hpp"

#include <bit>
#include <boost/test/unit_test.hpp>
#include <limits>
#include <random>
#include <vector>

#include "geometry/error.hpp"

namespace rayaudit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const std::string ray = " ray 0 0 5 0 0 -1";

const Answer& answer_of(const CaseLine& line) { return *line.answer; }

double read_number(const std::string& word) {
  return std::get<Sphere<double>>(read_case_line("sphere 0 0 0 " + word + ray).question.shape)
      .radius;
}

Real read_t(const std::string& word) {
  return answer_of(read_case_line("sphere 0 0 0 1" + ray + " hit " + word)).t;
}

std::string written(double number) {
  std::string line;
  write(line, number);
  return line;
}

std::string written(const Real& number) {
  std::string line;
  write(line, number);
  return line;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// The sentence that a malformed line is refused with; empty where it is read.
std::string refusal(const std::string& line) {
  try {
    read_case_line(line);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

BOOST_AUTO_TEST_CASE(each_shape_is_read_in_the_order_of_its_parameters) {
  const std::string along = " ray 1 2 3 4 5 6";
  const Ray<double> along_ray = {{1, 2, 3}, {4, 5, 6}};
  BOOST_TEST((read_case_line("disk 1 2 3 4 5 6 7" + along).question ==
              Case{along_ray, Disk<double>{{1, 2, 3}, {4, 5, 6}, 7}}));
  BOOST_TEST((read_case_line("sphere 1 2 3 4" + along).question ==
              Case{along_ray, Sphere<double>{{1, 2, 3}, 4}}));
  BOOST_TEST((read_case_line("cylinder 1 2 3 4 5 6 7" + along).question ==
              Case{along_ray, Cylinder<double>{{1, 2, 3}, {4, 5, 6}, 7}}));
  BOOST_TEST((read_case_line("cone 1 2 3 4 5 6 7" + along).question ==
              Case{along_ray, Cone<double>{{1, 2, 3}, {4, 5, 6}, 7}}));
}

BOOST_AUTO_TEST_CASE(an_extent_stands_after_the_numbers_of_a_shape_that_has_one) {
  const auto extent_of = [](const std::string& shape) {
    const Case question = read_case_line(shape + ray).question;
    BOOST_TEST((read_case_line(case_line(question)).question == question), shape);
    return question.extent;
  };
  BOOST_TEST((extent_of("disk 1 2 3 4 5 6 7 unbounded") == Extent::unbounded));
  BOOST_TEST((extent_of("cylinder 1 2 3 4 5 6 7  unbounded") == Extent::unbounded));
  BOOST_TEST((extent_of("cone 1 2 3 4 5 6 7 unbounded") == Extent::unbounded));
  BOOST_TEST((extent_of("cone 1 2 3 4 5 6 7 both_nappes") == Extent::both_nappes));
  BOOST_TEST((extent_of("cone 1 2 3 4 5 6 7") == Extent::bounded));
  BOOST_TEST(
      case_line(read_case_line("cone 1 2 3 4 5 6 0.5 both_nappes" + ray).question)
          .ends_with(" 0x1p-1 both_nappes ray 0x0p+0 0x0p+0 0x1.4p+2 0x0p+0 0x0p+0 -0x1p+0"));
  // Of a closed shape there is none to write.
  Case closed = read_case_line("capped_cone 1 2 3 4 5 6 7" + ray).question;
  closed.extent = Extent::unbounded;
  BOOST_TEST(case_line(closed).find("unbounded") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(an_extent_that_is_none_is_refused) {
  BOOST_TEST(refusal("sphere 1 2 3 4 unbounded" + ray) ==
             "expected `ray` after the sphere's 4 numbers, got `unbounded`");
  BOOST_TEST(refusal("capped_cone 1 2 3 4 5 6 7 both_nappes" + ray) ==
             "expected `ray` after the capped_cone's 7 numbers, got `both_nappes`");
  BOOST_TEST(refusal("disk 1 2 3 4 5 6 7 unbounded 8" + ray) ==
             "expected `ray` after `unbounded`, got `8`");
  BOOST_TEST(refusal("cone 1 2 3 4 5 6 7 both_nappes unbounded" + ray) ==
             "expected `ray` after `both_nappes`, got `unbounded`");
  BOOST_TEST(refusal("cone 1 2 3 4 5 6 7 bounded" + ray) ==
             "expected `ray` after the cone's 7 numbers, got `bounded`");
  BOOST_TEST(refusal("cone 1 2 3 4 5 6 7 unbounded") ==
             "expected `ray` after `unbounded`, got the end of the line");
}

BOOST_AUTO_TEST_CASE(range_answer_and_comment_are_each_optional) {
  const CaseLine bare = read_case_line("sphere 0 0 0 1" + ray);
  BOOST_TEST(bare.question.ray.t_min == 0);
  BOOST_TEST(bare.question.ray.t_max == infinity);
  BOOST_TEST(!bare.answer);
  BOOST_TEST(bare.why == "");
  const std::string line = "\t sphere 0 0 0 1" + ray + " range -inf 0x1p3  hit 4\t#  head on \r";
  const CaseLine full = read_case_line(line);
  BOOST_TEST(full.question.ray.t_min == -infinity);
  BOOST_TEST(full.question.ray.t_max == 8);
  BOOST_TEST((full.answer == Answer::hit(real(4.0))));
  BOOST_TEST(full.why == "head on");
  const std::string close = "sphere 0 0 0 1" + ray + "#why";
  BOOST_TEST(read_case_line(close).why == "why");
}

BOOST_AUTO_TEST_CASE(each_form_of_answer_is_read) {
  const auto answer = [](const std::string& words) {
    return answer_of(read_case_line("sphere 0 0 0 1" + ray + words));
  };
  BOOST_TEST((answer(" miss") == Answer::miss()));
  BOOST_TEST((answer(" yes") == Answer::yes()));
  BOOST_TEST((answer(" hit -0x1.8p+1") == Answer::hit(real(-3.0))));
  BOOST_TEST((answer(" at 0 -0.5 0x1p-1") == Answer::at({real(0.0), real(-0.5), real(0.5)})));
  BOOST_TEST(is_nan(answer(" hit nan").t));
  BOOST_TEST(is_infinite(answer(" hit -inf").t));
}

BOOST_AUTO_TEST_CASE(numbers_are_read_as_c_writes_them) {
  BOOST_TEST(read_number("0x1.8p+1") == 3);
  BOOST_TEST(read_number("0X1.8P+1") == 3);
  BOOST_TEST(read_number("0xC") == 12);
  BOOST_TEST(read_number("0x.8") == 0.5);
  BOOST_TEST(read_number("0x0.0000000000001p-1022") == 0x1p-1074);
  BOOST_TEST(read_number("+1.5e+1") == 15);
  BOOST_TEST(read_number("-.5") == -0.5);
  BOOST_TEST(read_number("0.1") == 0.1);
  BOOST_TEST(read_number("5e-324") == 0x1p-1074);
  BOOST_TEST(read_number("1e-400") == 0);
  BOOST_TEST(read_number("INF") == infinity);
  BOOST_TEST(read_number("-infinity") == -infinity);
  BOOST_TEST(std::isnan(read_number("NaN")));
  BOOST_TEST(same_bits(read_number("-0"), -0.0));
  BOOST_TEST(same_bits(read_number("-0x0p+0"), -0.0));
}

BOOST_AUTO_TEST_CASE(hex_digits_beyond_a_double_are_rounded_once) {
  BOOST_TEST(read_number("0x1.00000000000008p+0") == 1);
  BOOST_TEST(read_number("0x1.000000000000080000000000000000001p+0") == 1 + 0x1p-52);
  BOOST_TEST(read_number("0x1.00000000000018p+0") == 1 + 0x1p-51);
  BOOST_TEST(read_number("0x0.00000000000008p-1022") == 0);
  BOOST_TEST(read_number("0x0.000000000000080000000001p-1022") == 0x1p-1074);
  BOOST_TEST(read_number("0x1.fffffffffffff7ffffffp+1023") == std::numeric_limits<double>::max());
  BOOST_TEST(read_number("0x0.00000000000000000000000000000000000000000001p+176") == 1);
  BOOST_TEST(read_number("0x100000000000000000000000000000000000000000000p-176") == 1);
}

BOOST_AUTO_TEST_CASE(an_answer_keeps_three_doubles_worth_of_digits) {
  BOOST_TEST(compare(read_t("0x1.8p+5000"), {3, 0, 0, 4999}) == 0);
  BOOST_TEST(compare(read_t("-0x1p-5000"), {-1, 0, 0, -5000}) == 0);
  BOOST_TEST(compare(read_t("0x1.000000000000000000000000008p+0"), {1, 0x1p-105, 0, 0}) == 0);
  BOOST_TEST(compare(read_t("0x1.0000000000000000000000000080000000000000000000000000000001p+0"),
                     {1, 0x1p-105, 0x1p-232, 0}) == 0);
  BOOST_TEST((read_t("0x1.000000000000008p+0") == Real{1, 0x1p-57, 0, 0}));
}

BOOST_AUTO_TEST_CASE(a_double_is_written_as_short_as_it_goes) {
  BOOST_TEST(written(3.0) == "0x1.8p+1");
  BOOST_TEST(written(-1.0) == "-0x1p+0");
  BOOST_TEST(written(0.0) == "0x0p+0");
  BOOST_TEST(written(-0.0) == "-0x0p+0");
  BOOST_TEST(written(0.1) == "0x1.999999999999ap-4");
  BOOST_TEST(written(0x1p-1074) == "0x1p-1074");
  BOOST_TEST(written(0x1.8p-1073) == "0x1.8p-1073");
  BOOST_TEST(written(std::numeric_limits<double>::max()) == "0x1.fffffffffffffp+1023");
  BOOST_TEST(written(infinity) == "inf");
  BOOST_TEST(written(-infinity) == "-inf");
  BOOST_TEST(written(-std::numeric_limits<double>::quiet_NaN()) == "nan");
}

BOOST_AUTO_TEST_CASE(a_real_is_written_in_one_hex_float) {
  BOOST_TEST(written(real(-0.0)) == "-0x0p+0");
  BOOST_TEST(written(real(infinity)) == "inf");
  BOOST_TEST(written(Real{3, 0, 0, 5000}) == "0x1.8p+5001");
  BOOST_TEST(written(Real{-1, -0x1p-64, 0, 0}) == "-0x1.0000000000000001p+0");
  BOOST_TEST(written(Real{1, -0x1p-64, 0, 0}) == "0x1.fffffffffffffffep-1");
  BOOST_TEST(written(Real{1, 0x1p-60, 0x1p-120, 0}) == "0x1.000000000000001000000000000001p+0");
  BOOST_TEST(written(Real{1, -1, 0, 3}) == "0x0p+0");
  BOOST_TEST(written(Real{0x1p1023, 0x1p1023, 0, 1}) == "0x1p+1025");
  BOOST_TEST(written(Real{0x1p1020, 0x1p956, 0, 1}) == "0x1.0000000000000001p+1021");
}

BOOST_AUTO_TEST_CASE(every_double_comes_back_bit_for_bit) {
  std::mt19937_64 engine(7);
  for (int i = 0; i < 200'000; ++i) {
    const double number = std::bit_cast<double>(engine() >> (i % 3 == 0 ? engine() % 64 : 0));
    if (std::isnan(number)) continue;
    BOOST_TEST_REQUIRE(same_bits(read_number(written(number)), number), written(number));
    const Real as_answer = read_t(written(number));
    BOOST_TEST_REQUIRE(same_bits(as_answer.high, number), written(number));
  }
}

BOOST_AUTO_TEST_CASE(every_real_comes_back_exactly) {
  std::mt19937_64 engine(11);
  const auto part = [&](int exponent) {
    return std::ldexp(static_cast<double>(static_cast<std::int64_t>(engine())), exponent - 63);
  };
  for (int i = 0; i < 50'000; ++i) {
    const int gap = static_cast<int>(engine() % 400);
    const int shift = static_cast<int>(engine() % 40'000) - 20'000;
    const Real number = {part(0), part(-54 - gap), part(-108 - 2 * gap), i % 2 == 0 ? 0 : shift};
    const Real back = read_t(written(number));
    BOOST_TEST_REQUIRE(compare(back, number) == 0, written(number));
  }
}

BOOST_AUTO_TEST_CASE(a_case_line_comes_back_as_it_was) {
  const std::vector<Case> cases = {
      {{{1, -0.0, 0.1}, {0x1p-1074, 1e300, -3}}, Disk<double>{{1, 2, 3}, {-4, 0, 0.3}, 7}},
      {{{0, 0, 5}, {0, 0, -1}, 0.25, 8}, Sphere<double>{{0, 0, 0}, 1}},
      {{{0, 0, 5}, {0, 0, -1}, -infinity, 0}, Cylinder<double>{{0, 0, 0}, {0, 1, 0}, 1}},
      {{{0, 0, 5}, {0, 0, -1}, -0.0, infinity}, Sphere<double>{{0, 0, 0}, 1}},
      {{{0, 0, 5}, {0, 0, -1}, 0, infinity}, Cone<double>{{0, 0, 0}, {0, 1, 0}, infinity}},
  };
  for (const Case& question : cases) {
    const std::string line = case_line(question);
    BOOST_TEST((read_case_line(line).question == question), line);
    BOOST_TEST(case_line(read_case_line(line).question) == line);
  }
  BOOST_TEST(case_line(cases[1]) ==
             "sphere 0x0p+0 0x0p+0 0x0p+0 0x1p+0 ray 0x0p+0 0x0p+0 0x1.4p+2 "
             "0x0p+0 0x0p+0 -0x1p+0 range 0x1p-2 0x1p+3");
  BOOST_TEST(case_line(cases[3]).ends_with(" range -0x0p+0 inf"));
  BOOST_TEST(case_line(cases[4]).find("range") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(an_answer_is_written_as_it_is_read) {
  const Answer answers[] = {Answer::miss(), Answer::yes(), Answer::hit({1, 0x1p-70, 0, 0}),
                            Answer::at({real(1.0), real(-0.0), real(0x1p-3)})};
  for (const Answer& answer : answers) {
    std::string line = "sphere 0 0 0 1" + ray + " ";
    write(line, answer);
    BOOST_TEST((answer_of(read_case_line(line)) == answer), line);
  }
}

BOOST_AUTO_TEST_CASE(a_malformed_line_is_told_what_was_expected_where) {
  BOOST_TEST(refusal("") == "expected a shape, got the end of the line");
  BOOST_TEST(refusal("shpere 0 0 0 1" + ray) ==
             "shape `shpere` is not known; did you mean `sphere`?");
  BOOST_TEST(refusal("sphere 0 0 0 abc" + ray) == "sphere: expected radius, got `abc`");
  BOOST_TEST(refusal("cone 0 0 0 1 x") == "cone: expected apex y, got `x`");
  BOOST_TEST(refusal("disk 0 0") == "disk: expected centre z, got the end of the line");
  BOOST_TEST(refusal("sphere 0 0 0 1 rya 0") ==
             "expected `ray` after the sphere's 4 numbers, got `rya`");
  BOOST_TEST(refusal("cylinder 0 0 0 1 1 1 1") ==
             "expected `ray` after the cylinder's 7 numbers, got the end of the line");
  BOOST_TEST(refusal("sphere 0 0 0 1 ray 0 0 0 0 0") ==
             "ray: expected direction z, got the end of the line");
  BOOST_TEST(refusal("sphere 0 0 0 1" + ray + " range 0") ==
             "range: expected t_max, got the end of the line");
  BOOST_TEST(refusal("sphere 0 0 0 1" + ray + " hti 3") ==
             "expected `range`, `hit`, `at`, `yes`, `miss` or nothing after the ray's 6 numbers, "
             "got `hti`");
  BOOST_TEST(refusal("sphere 0 0 0 1" + ray + " range 0 1 range") ==
             "expected `hit`, `at`, `yes`, `miss` or nothing after the range's 2 numbers, "
             "got `range`");
  BOOST_TEST(refusal("sphere 0 0 0 1" + ray + " hit") ==
             "hit: expected t, got the end of the line");
  BOOST_TEST(refusal("sphere 0 0 0 1" + ray + " at 1 2 # 3") ==
             "at: expected point z, got the end of the line");
  BOOST_TEST(refusal("sphere 0 0 0 1" + ray + " miss 3") ==
             "expected nothing after the answer, got `3`");
}

BOOST_AUTO_TEST_CASE(a_malformed_number_is_refused) {
  for (const std::string word :
       {"-", "+", "0x", "0x.", "0x1p", "0x1p+", "0x1p+-5", "0x1p--5", "0x1.2.3", "0x1g", "1e",
        "1.5x", "--1", "+-1", "1,5", "0x1p1.5", "-0x-1"})
    BOOST_TEST(refusal("sphere 0 0 0 " + word + ray) ==
               "sphere: expected radius, got `" + word + "`");
}

BOOST_AUTO_TEST_CASE(a_number_that_overflows_is_refused) {
  for (const std::string word : {"1e400", "-1e309", "0x1p+1024", "0x1.fffffffffffff8p+1023"})
    BOOST_TEST(refusal("sphere 0 0 0 " + word + ray) ==
               "sphere: radius `" + word + "` overflows a double");
  BOOST_TEST(refusal("sphere 0 0 0 1" + ray + " hit 1e400") == "hit: t `1e400` overflows a double");
  BOOST_TEST(refusal("sphere 0 0 0 1" + ray + " hit 0x1p+99999999999") ==
             "hit: the exponent of t `0x1p+99999999999` is beyond 1000000");
  BOOST_TEST(refusal("sphere 0 0 0 1" + ray + " hit 0x1p-2147483648") ==
             "hit: the exponent of t `0x1p-2147483648` is beyond 1000000");
  const std::string long_word =
      "0x1" + std::string(30, '0') + "1" + std::string(30, '0') + "1" + std::string(30, '0') + "1";
  BOOST_TEST(refusal("sphere 0 0 0 1" + ray + " hit " + long_word) ==
             "hit: t `" + long_word.substr(0, 60) + "...` has more digits than three doubles hold");
}

BOOST_AUTO_TEST_CASE(a_truth_is_read_for_its_answer) {
  const std::string words = "sphere 0 0 0 1" + ray;
  const auto read = [&](const std::string& truth) { return read_case_line(words + " " + truth); };
  BOOST_TEST((answer_of(read("touch tangent 3 miss")) == Answer::miss()));
  BOOST_TEST(
      (answer_of(read("touch start 0 touch within 1 0x1p+1 hit 5")) == Answer::hit(real(5.0))));
  BOOST_TEST((answer_of(read("invalid radius")) == Answer::miss()));
  BOOST_TEST(!read("touch rim 3").answer);
  BOOST_TEST(refusal(words + " touch") == "touch: expected its kind, got the end of the line");
  BOOST_TEST(refusal(words + " touch rmi 3") ==
             "kind of touch `rmi` is not known; did you mean `rim`?");
  BOOST_TEST(refusal(words + " touch within 3 miss") == "touch: expected last t, got `miss`");
  BOOST_TEST(refusal(words + " touch rim 3 invalid nan") ==
             "expected `touch`, `hit`, `at`, `yes`, `miss` or nothing after the touch, got "
             "`invalid`");
  BOOST_TEST(refusal(words + " invalid") == "invalid: expected why, got the end of the line");
  BOOST_TEST(refusal(words + " invalid nan miss") ==
             "expected nothing after the answer, got `miss`");
}

BOOST_AUTO_TEST_CASE(the_words_of_the_case_alone_are_told) {
  const std::string words = "  sphere 0 0 0 1\tray 0 0 5 0 0 -1";
  for (const std::string more : {"", " range 0 1"})
    for (const std::string rest : {"", " \t", " miss # why", "\thit 3", " touch rim 3 miss", "#"}) {
      const std::string line = words + more + rest;
      BOOST_TEST(read_case_line(line).words == words + more, line);
    }
}

BOOST_AUTO_TEST_CASE(comments_and_blank_lines_are_told_apart_from_cases) {
  BOOST_TEST(is_blank(""));
  BOOST_TEST(is_blank(" \t\r"));
  BOOST_TEST(is_blank("  # only words"));
  BOOST_TEST(!is_blank("sphere # a case, though not whole"));
  BOOST_TEST(comment_start("sphere # why") == 7u);
  BOOST_TEST(comment_start("sphere") == 6u);
}

}  // namespace
}  // namespace rayaudit
