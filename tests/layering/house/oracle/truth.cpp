#include "oracle/truth.hpp"

#include "settle.hpp"
