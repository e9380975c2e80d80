#include <fcntl.h>
#include <spawn.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "rayaudit/plugin.h"

/// POV-Ray as a plugin: a scene that asks trace() case after case while it is read, batch after
/// batch: to start it takes most of a second. Quoted is its reference of 3.7, and its source.
namespace {

namespace fs = std::filesystem;

[[noreturn]] void give_up(const std::string& why) {
  std::fprintf(stderr, "rayaudit-povray: %s\n", why.c_str());
  std::abort();
}

/// A number as it reads it without loss.
std::string literal(double x) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.17g", x);
  return text.data();
}
std::string literal(const rayaudit_vec3& v) {
  return '<' + literal(v.x) + ',' + literal(v.y) + ',' + literal(v.z) + '>';
}

std::string object(const rayaudit_disk& disk) {
  return "disc{" + literal(disk.centre) + ',' + literal(disk.normal) + ',' + literal(disk.radius) +
         '}';
}
std::string object(const rayaudit_sphere& sphere) {
  return "sphere{" + literal(sphere.centre) + ',' + literal(sphere.radius) + '}';
}
/// "The optional keyword open after the radius will remove the end caps" (Cylinder)
std::string object(const rayaudit_cylinder& cylinder, const char* open) {
  return "cylinder{" + literal(cylinder.base) + ',' + literal(cylinder.top) + ',' +
         literal(cylinder.radius) + open + '}';
}
std::string object(const rayaudit_cone& cone, const char* open) {
  return "cone{" + literal(cone.base) + ',' + literal(cone.radius) + ',' + literal(cone.apex) +
         ",0" + open + '}';
}

std::string object(const rayaudit_case& question) {
  switch (question.shape) {
    case RAYAUDIT_DISK:
      return object(question.is.disk);
    case RAYAUDIT_SPHERE:
      return object(question.is.sphere);
    case RAYAUDIT_CYLINDER:
      return object(question.is.cylinder, " open");
    case RAYAUDIT_CONE:
      return object(question.is.cone, " open");
    case RAYAUDIT_CAPPED_CYLINDER:
      return object(question.is.capped_cylinder, "");
    default:
      return object(question.is.capped_cone, "");
  }
}

/// Of each batch the cases are in the file `cases`, and its answers go through one of two pipes, in
/// turn: to open that makes it wait until they are wanted. An answer is a line: nothing, or a point
/// to a hundred decimals, for it has no way to write so many digits.
constexpr std::string_view scene =
    "#version 3.7;\nglobal_settings{assumed_gamma 1}\n"
    "#macro Ask(Object,From,Along)\n"
    "#local N=<0,0,0>;\n#local P=trace(Object,From,Along,N);\n"
    "#if(N.x=0&N.y=0&N.z=0) #write(To,\"miss\\n\") #else "
    "#write(To,str(P.x,0,100),\" \",str(P.y,0,100),\" \",str(P.z,0,100),\"\\n\") #end\n#end\n"
    "#while(1)\n"
    "#fopen To \"0\" write\n#include \"cases\"\n#fclose To\n"
    "#fopen To \"1\" write\n#include \"cases\"\n#fclose To\n"
    "#end\n";

/// POV-Ray, waiting in a folder of its own. Both are gone when this process is, however it ends: a
/// shell sees to that, which is no more of this process's group and hears its end.
class Waiting {
 public:
  Waiting() : folder_((fs::temp_directory_path() / "rayaudit-povray-XXXXXX").string()) {
    if (mkdtemp(folder_.data()) == nullptr) give_up("no temporary folder can be made");
    std::ofstream(in("scene.pov")) << scene;
    for (const char* pipe : {"0", "1"}) mkfifo(in(pipe).c_str(), 0600);
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) give_up("no pipe can be made");
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    std::string words[] = {"sh", "-c",
                           "cd \"$0\"; " RAYAUDIT_POVRAY
                           " +Iscene.pov +W1 +H1 -D -F +WT1 </dev/null >said 2>&1 & "
                           "read _; kill -9 $!; rm -rf \"$0\"",
                           folder_};
    std::array<char*, std::size(words) + 1> arguments = {};
    for (std::size_t i = 0; i < std::size(words); ++i) arguments[i] = words[i].data();
    pid_t shell = 0;
    const int fault = posix_spawnp(&shell, "sh", &actions, &attributes, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    close(ends[0]);
    if (fault != 0) give_up(std::string("sh: ") + std::strerror(fault));
  }

  std::string in(const char* file) const { return folder_ + '/' + file; }
  std::ifstream answers() { return std::ifstream(in(std::exchange(turn_, !turn_) ? "1" : "0")); }

 private:
  std::string folder_;
  bool turn_ = false;
};

/// What it says that was wrong.
std::string fault_in(const std::string& path) {
  for (int wait = 0; wait < 20; ++wait, usleep(50'000)) {  // it tells them after the answers
    std::ifstream said(path);
    for (std::string line; std::getline(said, line);)
      if (line.find("Error:") != line.npos) return line;
  }
  return "POV-Ray has ended";
}

rayaudit_answer answer_of(const std::string& line) {
  if (line == "miss") return rayaudit_miss();
  double x = 0, y = 0, z = 0;
  if (std::sscanf(line.c_str(), "%lf %lf %lf", &x, &y, &z) == 3) return rayaudit_at(x, y, z);
  rayaudit_answer garbage = rayaudit_miss();
  garbage.form = -1;
  return garbage;
}

/// It refuses axes shorter than its EPSILON, 1.0e-10, "Degenerate cylinder, base point = apex
/// point.", and reads no further; NaN and infinity it has no words for. No hit is had on these, and
/// so they are told as misses: to begin anew takes it most of a second.
bool is_refused(const rayaudit_case& question) {
  const int count = question.shape == RAYAUDIT_SPHERE ? 4 : 7;
  const double* const numbers = question.is.numbers;
  const auto is_finite = [](double x) { return std::isfinite(x); };
  if (!std::all_of(numbers, numbers + count, is_finite)) return true;
  for (const auto& [x, y, z] : {question.ray.origin, question.ray.direction})
    if (!is_finite(x) || !is_finite(y) || !is_finite(z)) return true;
  if (question.shape == RAYAUDIT_DISK || question.shape == RAYAUDIT_SPHERE) return false;
  const rayaudit_vec3 &base = question.is.cylinder.base, &end = question.is.cylinder.top;
  return std::hypot(end.x - base.x, end.y - base.y, end.z - base.z) < 1e-10;
}

/// What ends it ends us, and so is told of the case, which is then asked alone.
void answer(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  static Waiting waiting;
  {
    std::ofstream asked(waiting.in("cases"));
    for (std::size_t i = 0; i < count; ++i) {
      if (is_refused(cases[i])) {
        asked << "#write(To,\"miss\\n\")\n";
        continue;
      }
      asked << "Ask(" << object(cases[i]) << ',' << literal(cases[i].ray.origin) << ','
            << literal(cases[i].ray.direction) << ")\n";
    }
  }
  std::ifstream said = waiting.answers();
  std::size_t given = 0;
  for (std::string line; std::getline(said, line); ++given)
    if (given < count) answers[given] = answer_of(line);
  if (given != count) give_up(fault_in(waiting.in("said")));
}

/// "POV-Ray 3.7.0.10", as it says itself.
std::string version() {
  std::string said = "POV-Ray";
  FILE* const asked = popen(RAYAUDIT_POVRAY " --version 2>&1 </dev/null", "r");
  if (asked == nullptr) return said;
  std::array<char, 256> line;
  while (std::fgets(line.data(), line.size(), asked) != nullptr) {
    const std::string_view text(line.data());
    if (text.starts_with("POV-Ray ")) said = text.substr(0, text.find('\n'));
  }
  pclose(asked);
  return said;
}

/// It takes no range, but has one, in length: MIN_ISECT_DEPTH 1.0e-4, "Minimum distance that
/// qualifies as ray-object intersection", and MAX_DISTANCE 1.0e7 (its source's configuration).
/// Directions of any length it brings to length 1 itself (Parse_Trace).
constexpr rayaudit_convention declared() {
  rayaudit_convention made = {};
  made.line = 1, made.unit_direction = 1;
  made.t_min = 1e-4, made.t_max = 1e7;
  return made;
}

}  // namespace

const rayaudit_plugin* rayaudit_plugin_entry() {
  static const std::string about = version() + ", trace()";
  static const rayaudit_subject subjects[] = {{.name = "povray",
                                               .format = "double",
                                               .convention = declared(),
                                               .disk = answer,
                                               .sphere = answer,
                                               .cylinder = answer,
                                               .cone = answer,
                                               .capped_cylinder = answer,
                                               .capped_cone = answer,
                                               .about = about.c_str()}};
  static const rayaudit_plugin plugin = {RAYAUDIT_PLUGIN_VERSION, sizeof(rayaudit_case),
                                         sizeof(rayaudit_answer), sizeof(rayaudit_subject),
                                         std::size(subjects),     subjects};
  return &plugin;
}
