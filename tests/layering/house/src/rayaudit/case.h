#include "geometry/vec3.hpp"
