#pragma once
#include "../subjects/subject.hpp"
