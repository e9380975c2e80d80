#include "oracle/exact.hpp"
