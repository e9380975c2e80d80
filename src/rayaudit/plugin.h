#ifndef RAYAUDIT_PLUGIN_H
#define RAYAUDIT_PLUGIN_H

/// What a shared object defines to be audited: `rayaudit audit --plugin ./libmine.so`. C99 or
/// C++11; nothing to link. For instance
///
///     #include <rayaudit/plugin.h>
///
///     static void spheres(const rayaudit_case* cases, size_t count, rayaudit_answer* answers) {
///       for (size_t i = 0; i < count; ++i) {
///         const rayaudit_ray* ray = &cases[i].ray;
///         const rayaudit_sphere* sphere = &cases[i].is.sphere;
///         double t;
///         answers[i] = my_intersect(ray, sphere, &t) ? rayaudit_hit(t) : rayaudit_miss();
///       }
///     }
///
///     static const rayaudit_subject subjects[] = {
///         {.name = "mine", .format = "float", .sphere = spheres}};
///     RAYAUDIT_PLUGIN(subjects)
///
/// It is loaded by a child process: what it does to its process is told as a finding, and no more.

#include <stddef.h>
#include <stdint.h>

#include "case.h"
#include "convention.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Of this header. A program knows every version up to its own.
#define RAYAUDIT_PLUGIN_VERSION 1u

/// Answers count cases, all of one shape: answers[i] is to be the answer to cases[i]. All answers
/// are misses when it is called. One call at a time.
typedef void (*rayaudit_batch)(const rayaudit_case* cases, size_t count, rayaudit_answer* answers);

typedef struct rayaudit_subject {
  const char* name;    ///< one word; reports call the subject name/format
  const char* format;  ///< what it works in: float, double or long_double
  rayaudit_convention convention;
  rayaudit_batch disk, sphere, cylinder, cone;  ///< null where it does not answer the shape
  rayaudit_batch capped_cylinder, capped_cone;
  const char* about;  ///< what it is, as `Embree 3.13.5, rtcIntersect1`; may be null
} rayaudit_subject;

typedef struct rayaudit_plugin {
  uint32_t version;  ///< RAYAUDIT_PLUGIN_VERSION; comes first in every version
  uint32_t case_size, answer_size, subject_size;
  size_t count;
  const rayaudit_subject* subjects;
} rayaudit_plugin;

#define RAYAUDIT_PLUGIN_ENTRY "rayaudit_plugin_entry"

/// The one symbol of a plugin.
__attribute__((visibility("default"))) const rayaudit_plugin* rayaudit_plugin_entry(void);

#ifdef __cplusplus
}
#endif

/// Defines it, from an array of subjects.
#define RAYAUDIT_PLUGIN(array)                                                 \
  const rayaudit_plugin* rayaudit_plugin_entry(void) {                         \
    static const rayaudit_plugin plugin = {RAYAUDIT_PLUGIN_VERSION,            \
                                           (uint32_t)sizeof(rayaudit_case),    \
                                           (uint32_t)sizeof(rayaudit_answer),  \
                                           (uint32_t)sizeof(rayaudit_subject), \
                                           sizeof(array) / sizeof((array)[0]), \
                                           array};                             \
    return &plugin;                                                            \
  }

#endif
