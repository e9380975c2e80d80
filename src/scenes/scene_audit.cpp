#include "scenes/scene_audit.hpp"
