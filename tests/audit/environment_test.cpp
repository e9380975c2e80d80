#include "audit/environment.hpp"

#include <boost/test/unit_test.hpp>
#include <cfenv>
#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace rayaudit {
namespace {

BOOST_AUTO_TEST_CASE(this_program_computes_as_written) {
  const Environment found = environment();
  BOOST_TEST(!found.contraction);
  BOOST_TEST(!found.flush_to_zero);
  BOOST_TEST(found.rounding == "to nearest");
}

BOOST_AUTO_TEST_CASE(compiler_flags_and_processor_are_named) {
  const Environment found = environment();
  BOOST_TEST(found.compiler.find('.') != found.compiler.npos);
  BOOST_TEST(found.flags.find("-ffp-contract=off") != found.flags.npos);
  BOOST_TEST(!found.processor.empty());
  BOOST_TEST(found.processor.find(':') == found.processor.npos);
}

BOOST_AUTO_TEST_CASE(the_rounding_mode_is_that_of_this_thread) {
  const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
  const char* const names[] = {"upward", "downward", "toward zero"};
  for (int i = 0; i < 3; ++i) {
    std::fesetround(modes[i]);
    const std::string found = environment().rounding;
    std::fesetround(FE_TONEAREST);
    BOOST_TEST(found == names[i]);
  }
}

#ifdef __SSE2__
BOOST_AUTO_TEST_CASE(lost_subnormal_numbers_are_noticed_as_results_and_as_operands) {
  constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
  const unsigned plain = _mm_getcsr();
  for (const unsigned mode : {flush_to_zero, denormals_are_zero}) {
    _mm_setcsr(plain | mode);
    const bool found = environment().flush_to_zero;
    _mm_setcsr(plain);
    BOOST_TEST(found, "mode " << mode);
  }
}
#endif

}  // namespace
}  // namespace rayaudit
