#include "scenes/bounding_tree.hpp"
