#pragma once

#include <string>

#include "audit/judge.hpp"

namespace rayaudit {

/// Is an answer not wrong, and its t within so many ulps where they are above 0?
bool agrees(const Judgement& judgement, double max_ulp);

/// One answer that was judged, and what is known of it.
struct JudgedAnswer {
  const Case& question;
  const Answer& answer;
  const Format& format;
  const Judgement& judgement;
  double margin = Judgement::unmeasured;  ///< in u of the format
  double max_ulp = 0;                     ///< that a right answer may be off by; 0: any
  std::string cause = {};                 ///< empty where it is not known
  bool repeats = true;                    ///< does it show again?
  std::string command = {};               ///< that explains it
};

/// The same for a person to read, a line each: case, got, truth, verdict, error and margin where
/// they are known, cause, and the command that explains it. Each line ended.
std::string failure_text(const JudgedAnswer& judged);

/// One answer to one case, for a person to read and to go on from: case, got, truth, verdict,
/// error, margin, cause where an answer alone shows it, and the command that explains it. Lines,
/// each of them ended.
std::string failure_text(const Case& question, const Answer& answer, const Format& format,
                         const Convention& convention, double max_ulp);

}  // namespace rayaudit
