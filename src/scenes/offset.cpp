#include "scenes/offset.hpp"
