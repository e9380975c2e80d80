#include "geometry/digest.hpp"

#include <boost/test/unit_test.hpp>

namespace rayaudit {
namespace {

std::uint64_t of(std::string_view bytes) {
  Digest digest;
  digest.add(bytes);
  return digest.value();
}

BOOST_AUTO_TEST_CASE(known_texts_have_the_published_digests) {
  BOOST_TEST(of("") == 0xcbf29ce484222325);
  BOOST_TEST(of("a") == 0xaf63dc4c8601ec8c);
  BOOST_TEST(of("foobar") == 0x85944171f73967e8);
}

BOOST_AUTO_TEST_CASE(a_number_is_its_eight_bytes_the_lowest_first) {
  Digest digest;
  digest.add(1.0);
  using namespace std::string_view_literals;
  BOOST_TEST(digest.value() == of("\0\0\0\0\0\0\xf0\x3f"sv));
  Digest zero, negative_zero;
  zero.add(0.0);
  negative_zero.add(-0.0);
  BOOST_TEST(zero.value() != negative_zero.value());
}

}  // namespace
}  // namespace rayaudit
