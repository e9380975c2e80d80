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
    // In place of an answer, of a subject that runs in a process of its own:
    crashed,    ///< its process ended
    garbage,    ///< what it said is no answer
    timed_out,  ///< it said nothing for as long as it was given
    unasked,    ///< it crashed or timed out too often before
  };

  Form form = Form::miss;
  Real t = {};            ///< of a hit
  Vec3<Real> point = {};  ///< of an at
  /// Of a subject that works in stages: which of them answered, from 1. No part of what is said.
  std::uint8_t stage = 0;
  /// Of a crashed: the signal that ended the process, or 0. No part of what is said.
  std::uint8_t signal = 0;

  /// Is it an answer, and not what stands in place of one?
  bool is_given() const { return form <= Form::yes; }

  friend bool operator==(const Answer& a, const Answer& b) {
    if (a.form != b.form) return false;
    if (a.form == Form::hit) return a.t == b.t;
    return a.form != Form::at || a.point == b.point;
  }

  static Answer miss() { return {}; }
  static Answer yes() { return {.form = Form::yes}; }
  static Answer hit(const Real& t) { return {.form = Form::hit, .t = t}; }
  static Answer crashed(int signal) {
    return {.form = Form::crashed, .signal = static_cast<std::uint8_t>(signal)};
  }
  static Answer garbage() { return {.form = Form::garbage}; }
  static Answer timed_out() { return {.form = Form::timed_out}; }
  static Answer unasked() { return {.form = Form::unasked}; }
  static Answer at(const Vec3<Real>& point) { return {.form = Form::at, .point = point}; }
};

}  // namespace rayaudit
