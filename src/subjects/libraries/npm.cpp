#include <dlfcn.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rayaudit/plugin.h"

/// Libraries from npm as a plugin: a Node program beside it, npm/main.mjs, tells what it has and
/// answers. It lives as long as this process, and is of its group, so that it ends with it.
namespace {

using Json = nlohmann::json;

/// Room for as many; there is a batch for each of them.
constexpr std::size_t most_subjects = 24;

/// Where Node hears and is heard. What it prints is nobody's.
struct Pipes {
  int to = -1, from = -1;
};

std::string beside_the_plugin() {
  Dl_info where = {};
  dladdr(reinterpret_cast<const void*>(&rayaudit_plugin_entry), &where);
  const std::string file = where.dli_fname;
  return file.substr(0, file.rfind('/') + 1) + "npm/";
}

Pipes start(const std::string& folder) {
  int questions[2], answers[2];
  if (pipe2(questions, O_CLOEXEC) != 0 || pipe2(answers, O_CLOEXEC) != 0)
    throw std::runtime_error("no pipe to Node can be made");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, questions[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, answers[1], STDERR_FILENO + 1);
  // Opened anew: Node makes it one that does not wait, and ours may be somebody's standard output.
  const int errors = open("/proc/self/fd/2", O_WRONLY | O_APPEND | O_CLOEXEC);
  if (errors >= 0) posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 2);
  std::string words[] = {"node", folder + "main.mjs"};
  char* const arguments[] = {words[0].data(), words[1].data(), nullptr};
  pid_t node = 0;
  const int fault = posix_spawnp(&node, RAYAUDIT_NODE, &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  for (const int end : {questions[0], answers[1], errors}) close(end);
  if (fault != 0) throw std::runtime_error(std::string(RAYAUDIT_NODE ": ") + std::strerror(fault));
  return {questions[1], answers[0]};
}

bool receive(int from, void* bytes, std::size_t size) {
  auto* next = static_cast<char*>(bytes);
  while (size > 0) {
    const ssize_t got = read(from, next, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    next += got, size -= static_cast<std::size_t>(got);
  }
  return true;
}

bool send(int to, const void* bytes, std::size_t size) {
  const auto* next = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t sent = write(to, next, size);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    next += sent, size -= static_cast<std::size_t>(sent);
  }
  return true;
}

/// The place of a word among those that a member of a convention may have.
std::int32_t place_of(const std::string& word, std::initializer_list<std::string_view> words) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) throw std::runtime_error("a convention has the word " + word);
  return static_cast<std::int32_t>(found - words.begin());
}

/// A convention in the words of --convention: {"tangent": "hit", "direction": "unit"}.
rayaudit_convention convention_of(const Json& said) {
  rayaudit_convention made = {};
  const double infinity = std::numeric_limits<double>::infinity();
  made.t_min = said.value("t_min", -infinity), made.t_max = said.value("t_max", infinity);
  const std::pair<const char*, std::int32_t*> stances[] = {
      {"tangent", &made.tangent}, {"rim", &made.rim}, {"apex", &made.apex},
      {"start", &made.start},     {"end", &made.end}, {"within", &made.within}};
  for (const auto& [kind, stance] : stances)
    *stance = place_of(said.value(kind, "either"), {"either", "hit", "miss"});
  made.inside = place_of(said.value("inside", "hit"), {"hit", "miss", "start"});
  made.unit_direction = place_of(said.value("direction", "any"), {"any", "unit"});
  const std::int32_t ray = place_of(said.value("ray", "half"), {"half", "line", "segment"});
  made.line = ray == 1, made.segment = ray == 2;
  made.extent = place_of(said.value("extent", "bounded"), {"bounded", "unbounded", "both_nappes"});
  made.stand = place_of(said.value("stand", "anywhere"), {"anywhere", "upright_y", "upright_z"});
  made.opening = place_of(said.value("opening", "radius"), {"radius", "angle", "cosine"});
  return made;
}

/// What Node says of itself.
struct Said {
  std::string name, format, about;
  rayaudit_convention convention;
  std::array<bool, 6> answers;
};

Said said_of(const Json& subject) {
  Said made = {subject.at("name"), subject.at("format"), subject.at("about"), {}, {}};
  made.convention = convention_of(subject.at("convention"));
  for (const std::string shape : subject.at("shapes"))
    made.answers[place_of(
        shape, {"disk", "sphere", "cylinder", "cone", "capped_cylinder", "capped_cone"})] = true;
  return made;
}

class Node {
 public:
  explicit Node(const std::string& folder) : pipes_(start(folder)) {
    double length = 0;
    std::string text;
    if (receive(pipes_.from, &length, sizeof length)) text.resize(static_cast<std::size_t>(length));
    if (text.empty() || !receive(pipes_.from, text.data(), text.size()))
      throw std::runtime_error("Node has nothing to say of " + folder + "main.mjs");
    const Json told = Json::parse(text);
    for (const Json& subject : told.at("subjects")) subjects.push_back(said_of(subject));
    for (const std::string why : told.at("absent")) absent.push_back(why);
    if (subjects.size() > most_subjects) throw std::runtime_error("there are too many subjects");
  }

  /// What ends Node ends us: its own words have gone to standard error.
  void answer(std::size_t subject, std::size_t shape, const rayaudit_case* cases, std::size_t count,
              rayaudit_answer* answers) const {
    constexpr std::size_t shape_numbers = 8;
    std::vector<double> question = {double(subject), double(shape), double(count)};
    question.reserve(3 + 16 * count);
    for (std::size_t i = 0; i < count; ++i) {
      const rayaudit_ray& ray = cases[i].ray;
      question.insert(question.end(), {ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x,
                                       ray.direction.y, ray.direction.z, ray.t_min, ray.t_max});
      question.insert(question.end(), cases[i].is.numbers, cases[i].is.numbers + shape_numbers);
    }
    std::vector<double> said(4 * count);
    if (!send(pipes_.to, question.data(), question.size() * sizeof question[0]) ||
        !receive(pipes_.from, said.data(), said.size() * sizeof said[0]))
      std::abort();
    for (std::size_t i = 0; i < count; ++i) {
      const double* const each = &said[4 * i];
      answers[i] = rayaudit_at(each[1], each[2], each[3]);
      answers[i].form = static_cast<std::int32_t>(each[0]);
      answers[i].t = each[1];
    }
  }

  std::vector<Said> subjects;
  std::vector<std::string> absent;

 private:
  Pipes pipes_;
};

/// Why not all are there that could be, on standard error.
void tell(const std::string& folder, const std::vector<std::string>& absent) {
  for (const std::string& why : absent) std::fprintf(stderr, "rayaudit-npm: %s\n", why.c_str());
  if (!absent.empty())
    std::fprintf(stderr, "rayaudit-npm: `npm ci` in %s fetches what is missing\n", folder.c_str());
}

/// The program that is asked; null where there is none, and why is told.
const Node* node() {
  static const Node* const made = []() -> const Node* {
    const std::string folder = beside_the_plugin();
    try {
      const auto* started = new Node(folder);
      tell(folder, started->absent);
      return started;
    } catch (const std::exception& why) {
      std::fprintf(stderr, "rayaudit-npm: %s\n", why.what());
      return nullptr;
    }
  }();
  return made;
}

template <std::size_t subject, std::size_t shape>
void batch(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  node()->answer(subject, shape, cases, count, answers);
}

using Batches = std::array<rayaudit_batch, 6>;

template <std::size_t... subject>
constexpr std::array<Batches, most_subjects> all_batches(std::index_sequence<subject...>) {
  return {Batches{batch<subject, 0>, batch<subject, 1>, batch<subject, 2>, batch<subject, 3>,
                  batch<subject, 4>, batch<subject, 5>}...};
}

std::vector<rayaudit_subject> subjects_of(const Node& asked) {
  static constexpr auto batches = all_batches(std::make_index_sequence<most_subjects>());
  std::vector<rayaudit_subject> made;
  for (const Said& said : asked.subjects) {
    const auto of = [&](std::size_t shape) {
      return said.answers[shape] ? batches[made.size()][shape] : nullptr;
    };
    made.push_back({said.name.c_str(), said.format.c_str(), said.convention, of(0), of(1), of(2),
                    of(3), of(4), of(5), said.about.c_str()});
  }
  return made;
}

}  // namespace

const rayaudit_plugin* rayaudit_plugin_entry() {
  static const auto subjects =
      node() == nullptr ? std::vector<rayaudit_subject>() : subjects_of(*node());
  static const rayaudit_plugin plugin = {RAYAUDIT_PLUGIN_VERSION, sizeof(rayaudit_case),
                                         sizeof(rayaudit_answer), sizeof(rayaudit_subject),
                                         subjects.size(),         subjects.data()};
  return &plugin;
}
