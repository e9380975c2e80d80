#include <boost/test/unit_test.hpp>

#include "geometry/error.hpp"
#include "reports/page.hpp"

// Built with an empty page, as it is where there is no npm.

BOOST_AUTO_TEST_CASE(without_npm_there_is_no_page_and_one_sentence_says_how_to_get_it) {
  BOOST_TEST(!rayaudit::has_page());
  const auto says_how = [](const rayaudit::Error& error) {
    return std::string_view(error.what()) ==
           "this build has no html reports: install npm, then configure and build again";
  };
  BOOST_CHECK_EXCEPTION(rayaudit::require_page(), rayaudit::Error, says_how);
  BOOST_CHECK_EXCEPTION(rayaudit::page("", "{}"), rayaudit::Error, says_how);
}
