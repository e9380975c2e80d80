#pragma once

#include <string>

#include "geometry/case_line.hpp"
#include "reports/exactly.hpp"
#include "scenes/scene_audit.hpp"

/// All of an account but its nanoseconds as text that is the same for the same account only.
namespace rayaudit {

inline std::string text_of(const std::optional<Case>& question) {
  return question ? case_line(*question) : "none";
}

inline std::string text_of(double number) {
  std::string text;
  write(text, number);
  return text;
}

inline std::string text_of(const Trouble& trouble) {
  return std::to_string(trouble.count) + ' ' + text_of(trouble.severity) + ' ' +
         text_of(trouble.example) + '\n';
}

inline std::string text_of(const WaveAccount& wave) {
  return std::string(name(wave.effect)) + ' ' + std::to_string(wave.bounce) + ' ' +
         std::to_string(wave.rays) + ' ' + std::to_string(wave.questions) + ' ' +
         exactly::written(wave.tally).dump() + '\n' + text_of(wave.self_intersections) +
         text_of(wave.leaks);
}

inline std::string text_of(const SceneAccount& account) {
  std::string text;
  for (const WaveAccount& wave : account.waves) text += text_of(wave);
  for (const OffsetAccount& offset : account.offsets)
    text += offset.offset.name + ' ' + std::to_string(offset.rays) + '\n' + text_of(offset.acne) +
            text_of(offset.lost_contact);
  const auto& [t_min, ulps, t_min_case, ulps_case, contact, contact_case] = account.safe;
  for (const double number : {t_min, ulps, contact}) text += text_of(number) + ' ';
  for (const auto& question : {t_min_case, ulps_case, contact_case}) text += text_of(question);
  const auto& [asked, settled, wrong, culled] = account.culling;
  return text + '\n' + std::to_string(asked) + ' ' + std::to_string(settled) + ' ' +
         std::to_string(culled) + ' ' + text_of(wrong);
}

}  // namespace rayaudit
