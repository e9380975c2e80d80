#include "reports/png_file.hpp"
