#pragma once

#include <string>
#include <string_view>

#include "families/family.hpp"
#include "geometry/error.hpp"
#include "subjects/subject.hpp"

/// Built-in subjects and families by their names, for tests.
namespace rayaudit {

inline const Subject* subject_of(std::string_view name) {
  for (const Subject& subject : built_in_subjects())
    if (subject.name == name) return &subject;
  throw Error("no subject " + std::string(name));
}

inline const Family* family_of(std::string_view id) {
  for (const Family& family : families())
    if (family.id == id) return &family;
  throw Error("no family " + std::string(id));
}

}  // namespace rayaudit
