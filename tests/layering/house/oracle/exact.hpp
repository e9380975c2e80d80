#pragma once
#include <CGAL/Mpzf.h>
