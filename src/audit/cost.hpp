#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "audit/accuracy.hpp"
#include "audit/audit.hpp"
#include "audit/spread.hpp"

namespace rayaudit {

/// What to measure: every subject on every shape that it answers and every family that draws it.
/// All of them on the same cases, drawn as floats.
struct CostPlan {
  std::vector<const Subject*> subjects;
  std::vector<const Family*> families;
  std::vector<std::size_t> shapes;
  std::uint64_t cases = 0;  ///< that are judged, for each subject, shape and family
  std::uint64_t seed = 0;
  int rounds = 0;
  int threads = 0;  ///< to judge on; 0: one for each processor
};

/// The cases that a subject is judged by, and timed on in each round, of each shape and family:
/// fewer of dear subjects, who are asked others of the same cases in the next round.
std::uint64_t judged_cases(const CostPlan& plan, const Subject& subject);
std::size_t timed_cases(const CostPlan& plan, const Subject& subject);

/// One way to answer: a subject with its price and its accuracy.
struct Way {
  const Subject* subject;
  std::vector<double> rounds;  ///< nanoseconds a case in each round
  Spread nanoseconds;
  std::size_t timed;  ///< cases in a round
  Accuracy accuracy;
  bool on_front = false;
};

/// Over which families the ways of a cell are measured: one; all; those that come as they may; or
/// those whose cases are degenerate or nearly so. Each family counts the same.
enum class Scope : std::uint8_t { family, all, easy, hard };
std::string_view name(Scope scope);
/// Does a family take part in a scope? Of the scope `family`, any may.
bool counts_in(Scope scope, const Family& family);

/// From a way of the front to the next more accurate one.
struct Step {
  const Way *from, *to;
  Spread times;  ///< the price of the one in units of the other's, round by round
};

/// All ways on one shape, in the order of the subjects.
struct Cell {
  std::size_t shape;
  Scope scope;
  const Family* family;  ///< null unless the scope is a family
  std::vector<Way> ways;

  /// The ways on the front, the fastest first.
  std::vector<const Way*> front() const;
  std::vector<Step> steps() const;
};

/// What a way costs on hard cases beside easy ones.
struct Price {
  const Way *easy, *hard;
  Spread times;
};

/// A subject that could not be timed, and why, in a sentence that names it.
struct Untimed {
  const Subject* subject;
  std::string why;
};

struct Cost {
  /// What each of the times holds for reading a case and writing an answer, in nanoseconds.
  Spread idle;
  std::vector<Cell> cells;  ///< by shape; of each all, easy, hard, where there are such; families
  std::vector<Untimed> untimed;

  /// Every way of a shape with its price on easy and on hard cases, in the order of the subjects.
  std::vector<Price> prices(std::size_t shape) const;
};

/// Marks the front. From the most accurate on it takes each way that is clearly faster than those
/// it has, and slower than none that is more accurate; of these, from the fastest on, it keeps each
/// that is clearly more accurate than the one before. So nothing is both faster and more accurate
/// than a way on it, and each step along it is more than chance.
void mark_front(std::vector<Way>& ways);

/// Times and judges. What is told is measured here and now, and differs from run to run but for
/// the verdicts.
Cost measure(const CostPlan& plan, const std::function<void(Progress)>& tell = {});

}  // namespace rayaudit
