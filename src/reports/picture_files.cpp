#include "reports/picture_files.hpp"
