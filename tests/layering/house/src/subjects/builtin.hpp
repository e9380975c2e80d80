#pragma once
#include "families/rim.hpp"
