#pragma once
#include "geometry/vec3.hpp"
#include "numbers/double_double.hpp"
