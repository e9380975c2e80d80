#pragma once
#include "geometry/vec3.hpp"
