#include "scenes/read_scene.hpp"
