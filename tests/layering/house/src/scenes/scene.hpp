#pragma once
#include "audit/judge.hpp"
