#pragma once

#include <string>

namespace rayaudit {

/// Where in which scene file something stands; lines and columns from 1.
struct Place {
  std::string file;
  int line = 1, column = 1;

  friend bool operator==(const Place&, const Place&) = default;
};

/// `planet.pbrt:12:5`.
inline std::string told(const Place& place) {
  return place.file + ':' + std::to_string(place.line) + ':' + std::to_string(place.column);
}

}  // namespace rayaudit
