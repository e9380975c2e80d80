#pragma once
#include "tests/audit/judge_test.cpp"
