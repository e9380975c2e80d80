#pragma once
#include "oracle/truth.hpp"
