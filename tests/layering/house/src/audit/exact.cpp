#include <CGAL/Gmpq.h>
#include <mpfr.h>

#include <boost/multiprecision/cpp_int.hpp>
