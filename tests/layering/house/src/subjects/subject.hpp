#pragma once
#include "geometry/vec3.hpp"
#include "oracle/truth.hpp"
#include "routines/textbook.hpp"
