#pragma once
#include "reports/json.hpp"
