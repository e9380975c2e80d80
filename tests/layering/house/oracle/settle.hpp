#pragma once
#include "exact.hpp"
