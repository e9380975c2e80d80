#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "audit/environment.hpp"
#include "audit/histogram.hpp"

/// What all reports in JSON have in common.
namespace rayaudit::json {

using Json = nlohmann::ordered_json;

/// JSON has no infinity and no NaN: they become "inf", "-inf" and null.
inline Json number(double x) {
  if (std::isnan(x)) return nullptr;
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return x;
}

/// Largest and quantiles of errors; null where nothing was measured.
inline Json errors(const Histogram& histogram) {
  const auto told = [&](double x) { return histogram.count() > 0 ? number(x) : Json(nullptr); };
  return {{"max", told(histogram.largest())},
          {"p50", told(histogram.quantile(0.5))},
          {"p99", told(histogram.quantile(0.99))},
          {"measured", histogram.count()}};
}

inline Json told(const Environment& environment) {
  return {{"compiler", environment.compiler},       {"flags", environment.flags},
          {"processor", environment.processor},     {"processors", environment.processors},
          {"contraction", environment.contraction}, {"flush_to_zero", environment.flush_to_zero},
          {"rounding", environment.rounding}};
}

inline Json tool(const std::string& version) {
  return {{"name", "rayaudit"}, {"version", version}};
}

/// A magnitude to as many digits as are read.
inline Json magnitude(double x) {
  return number(std::isfinite(x) ? std::strtod(fmt::format("{:.4g}", x).c_str(), nullptr) : x);
}

/// The text of a report. Bytes that are no UTF-8, in the name of a subject, must not stop it.
inline std::string written(const Json& report) {
  return report.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// The same with no more room than it takes: what a page holds.
inline std::string compact(const Json& report) {
  return report.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The same report, its figures as magnitudes.
inline Json shortened(Json report) {
  const auto shorten = [](auto& self, Json& part) -> void {
    if (part.is_number_float()) part = magnitude(part.get<double>());
    if (part.is_structured())
      for (Json& each : part) self(self, each);
  };
  shorten(shorten, report);
  return report;
}

}  // namespace rayaudit::json
