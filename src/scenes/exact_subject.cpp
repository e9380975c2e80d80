#include "scenes/tracer.hpp"
