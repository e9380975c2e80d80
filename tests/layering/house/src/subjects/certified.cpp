#include "oracle/settle.hpp"
