#define BOOST_TEST_MODULE rayaudit
#include <boost/test/unit_test.hpp>
