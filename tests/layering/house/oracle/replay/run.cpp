#include "oracle/truth.hpp"
