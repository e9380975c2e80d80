#pragma once
#include "families/rim.hpp"
#include "oracle/replay/replay.hpp"
#include "oracle/truth.hpp"
#include "subjects/subject.hpp"
