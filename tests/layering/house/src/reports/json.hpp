#pragma once
#include "audit/judge.hpp"
#include "oracle/truth.hpp"
