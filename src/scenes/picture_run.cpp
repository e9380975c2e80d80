#include "scenes/picture_run.hpp"
