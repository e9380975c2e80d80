#pragma once

#include <cstdint>

#include "geometry/real.hpp"
#include "geometry/vec3.hpp"

namespace rayaudit {

/// What a subject says of a case. What its form does not ask for may hold anything.
struct Answer {
  enum class Form : unsigned char {
    miss,  ///< they do not meet
    hit,   ///< they meet at t
    at,    ///< they meet at a point; t is then its exact projection ((p - o).d) / (d.d)
    yes,   ///< they meet, no word of where
  };

  Form form = Form::miss;
  Real t = {};            ///< of a hit
  Vec3<Real> point = {};  ///< of an at
  /// Of a subject that works in stages: which of them answered, from 1. No part of what is said.
  std::uint8_t stage = 0;

  friend bool operator==(const Answer& a, const Answer& b) {
    if (a.form != b.form) return false;
    if (a.form == Form::hit) return a.t == b.t;
    return a.form != Form::at || a.point == b.point;
  }

  static Answer miss() { return {}; }
  static Answer yes() { return {.form = Form::yes}; }
  static Answer hit(const Real& t) { return {.form = Form::hit, .t = t}; }
  static Answer at(const Vec3<Real>& point) { return {.form = Form::at, .point = point}; }
};

}  // namespace rayaudit
