#include "scenes/effect.hpp"
