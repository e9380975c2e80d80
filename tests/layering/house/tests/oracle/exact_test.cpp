#include <gmpxx.h>

#include "oracle/settle.hpp"
