#include "reports/json.hpp"
#include "routines/textbook.hpp"
