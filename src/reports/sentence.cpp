#include "reports/sentence.hpp"

namespace rayaudit {

std::string_view sentence(Verdict verdict) {
  switch (verdict) {
    case Verdict::false_hit:
      return "a hit where there is none";
    case Verdict::false_miss:
      return "a miss where there is a hit";
    case Verdict::wrong_root:
      return "a hit, but another than the first";
    case Verdict::wrong_t:
      return "the first hit, but t is far off";
    case Verdict::not_finite:
      return "a hit, but t is no finite number";
    case Verdict::crashed:
      return "no answer, the process of the subject ended";
    case Verdict::timed_out:
      return "no answer in the time it was given";
    case Verdict::invalid_mishandled:
      return "no clear miss where there is no ray or no shape";
    default:
      return name(verdict);
  }
}

std::string_view sentence(Claim claim) {
  switch (claim) {
    case Claim::none:
      return "";
    case Claim::no_root:
      return ", and the line does not meet it there";
    case Claim::nan:
      return ": t is NaN";
    case Claim::infinite:
      return ": t is infinite";
    case Claim::behind:
      return ": there the line meets it before the ray begins";
    case Claim::past:
      return ": there the line meets it after the ray ends";
    case Claim::clipped:
      return ": there the line is beside the disk, or above or below the shape";
    case Claim::mirrored:
      return ": there is the other nappe of the cone";
    case Claim::later:
      return ": a later one";
    case Claim::declined:
      return ": declared to be a miss";
    case Claim::parallel:
      return ": the ray runs parallel to it and never meets it";
    case Claim::centre:
      return ": the point told is the shape's own centre, a sentinel?";
    case Claim::origin:
      return ": the hit lies at the world origin, a sentinel?";
    case Claim::garbage:
      return ": what came is none that there is";
    case Claim::ended:
      return ": the process ended";
    case Claim::hung:
      return ": no answer came in time";
  }
  return "";
}

}  // namespace rayaudit
