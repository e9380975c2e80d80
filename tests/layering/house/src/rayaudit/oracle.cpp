#include "rayaudit/case.h"
#include "routines/textbook.hpp"
