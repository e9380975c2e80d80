#pragma once
#include <routines/textbook.hpp>
