#include "subjects/libraries/libraries.hpp"

#include <array>
#include <chrono>
#include <string>

#include "geometry/error.hpp"
#include "geometry/glob.hpp"

namespace rayaudit {
namespace {

namespace fs = std::filesystem;

constexpr std::array list = {
    Library{"bullet", "bullet*/float", "Bullet (Debian's libbullet-dev)"},
    Library{"bullet64", "bullet*/double", "Bullet in double (Debian's libbullet-dev)"},
    Library{"cgal", "cgal*/*", "CGAL, which the project needs anyway"},
    Library{"coin", "coin*/float", "Coin (Debian's libcoin-dev)"},
    Library{"eigen", "eigen*/*", "Eigen (Debian's libeigen3-dev)"},
    Library{"embree", "embree*/float", "Embree 3 (Debian's libembree-dev)"},
    Library{"geometric_shapes", "geometric_shapes*/double",
            "geometric_shapes of ROS (Debian's libgeometric-shapes-dev)"},
    Library{"glm", "glm*/*", "GLM (Debian's libglm-dev)"},
    Library{"imath", "imath*/*", "Imath (Debian's libimath-dev)"},
    Library{"irrlicht", "irrlicht*/*", "Irrlicht (Debian's libirrlicht-dev)"},
    Library{"mujoco", "mujoco*/double", "MuJoCo (Debian's libmujoco-dev)"},
    Library{"nanovdb", "nanovdb*/*", "NanoVDB (Debian's libnanovdb-dev)"},
    Library{"npm", "npm.*/*", "Node.js, npm, and the packages that ./dev libraries fetches"},
    Library{"ode", "ode*/*", "ODE (Debian's libode-dev)"},
    Library{"ogre", "ogre*/float", "OGRE (Debian's libogre-1.12-dev)"},
    Library{"opencascade", "opencascade*/double",
            "Open CASCADE (Debian's libocct-modeling-algorithms-dev)"},
    Library{"povray", "povray*/double", "POV-Ray (Debian's povray and povray-includes)"},
    Library{"simbody", "simbody*/double", "Simbody (Debian's libsimbody-dev)"},
    Library{"simgear", "simgear*/*", "SimGear (Debian's libsimgear-dev)"},
    Library{"wild_magic", "wild_magic*/*", "Wild Magic 5 (Debian's libwildmagic-dev)"},
};

/// Some take seconds to load where others keep the machine busy.
constexpr std::chrono::seconds library_patience{10};

std::string file_of(const Library& library) {
  return "rayaudit-" + std::string(library.plugin) + ".so";
}

}  // namespace

std::span<const Library> libraries() { return list; }

bool is_here(const Library& library, const fs::path& program) {
  return plugin_beside(program, library.plugin).has_value();
}

std::vector<Subject> subjects_of(const Library& library, const fs::path& program) {
  const auto plugin = plugin_beside(program, library.plugin);
  if (!plugin) throw Error(why_absent(library));
  std::vector<Subject> subjects = plugin_subjects(*plugin, library_patience, program);
  for (Subject& each : subjects) {
    // Under another name nobody could ask for it.
    if (!matches(std::string(library.subjects), each.name))
      throw Error("plugin `" + plugin->string() + "` has a subject `" + each.name +
                  "`, which is none of `" + std::string(library.subjects) + '`');
    each.by_name_only = true;
  }
  return subjects;
}

std::string why_absent(const Library& library) {
  return file_of(library) + " is not beside the program; it is built where there is " +
         std::string(library.needs);
}

}  // namespace rayaudit
