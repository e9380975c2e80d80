#pragma once

#include <string>
#include <vector>

#include "cli/selection.hpp"
#include "scenes/offset.hpp"
#include "scenes/scene.hpp"

namespace rayaudit {

/// Who makes a picture of a scene: a subject that decides, and an offset that its rays begin by.
struct Renderer {
  const Subject* subject;
  Offset offset;

  /// `textbook/float@t_min=1e-3`, as it may be asked for.
  std::string name() const;
  /// The same as part of a file's name: `textbook-float-t_min=1e-3`.
  std::string file_name() const;
};

/// The renderers that a command line asks for: names and globs of its choice, each with an offset
/// after an `@` or with t_min=1e-4. An offset alone is of what is brought along, else of
/// textbook/float; so is no name at all. Throws Error where one is not known or does not answer a
/// shape of the scene, NothingAudited where a glob leaves nobody.
std::vector<Renderer> renderers(const SubjectChoice& choice, const Subjects& subjects,
                                const Scene& scene);

}  // namespace rayaudit
