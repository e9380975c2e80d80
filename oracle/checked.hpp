#pragma once

#include <span>
#include <stdexcept>

#include "oracle/truth.hpp"

/// The checked mode: what lanes and intervals decided is decided again in exact numbers.
namespace rayaudit::oracle {

/// A decision of the oracle's own that exact numbers do not confirm: no verdict would mean
/// anything.
struct Disagreement : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// From now on, and in every thread, truth checks each of its decisions. Not to be called while
/// another thread is in truth.
void check_every_decision();
bool checks_every_decision();

/// Throws Disagreement, which names the case, where exact numbers say another than this truth:
/// other crossings, or one whose t is further than 2^-bits |t| away, or a root that is none.
void confirm(const Case& question, const Truth& truth, int bits);

}  // namespace rayaudit::oracle
