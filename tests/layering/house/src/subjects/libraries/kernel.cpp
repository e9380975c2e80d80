#include <CGAL/Sphere_3.h>

#include "subjects/subject.hpp"
