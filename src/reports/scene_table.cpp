#include "reports/scene_run.hpp"
