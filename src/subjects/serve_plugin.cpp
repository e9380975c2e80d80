#include "subjects/serve_plugin.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "subjects/plugin_message.hpp"

namespace rayaudit {
namespace {

/// Where whoever asks is heard and answered.
int asker = -1;

/// Does all of it come? Else whoever asks has gone.
bool receive(void* bytes, std::size_t size) {
  auto* next = static_cast<char*>(bytes);
  while (size > 0) {
    const ssize_t got = read(asker, next, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    next += got, size -= static_cast<std::size_t>(got);
  }
  return true;
}

void send(const void* bytes, std::size_t size) {
  const auto* next = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t sent = write(asker, next, size);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) std::_Exit(EXIT_FAILURE);
    next += sent, size -= static_cast<std::size_t>(sent);
  }
}

template <class T>
void reply(std::span<const T> all, double nanoseconds = 0) {
  const PluginReply head = {.bytes = all.size_bytes(), .nanoseconds = nanoseconds};
  send(&head, sizeof head);
  send(all.data(), all.size_bytes());
}

/// A sentence about the plugin as it goes on; the last word there is.
[[noreturn]] void refuse(std::string_view why) {
  why = why.substr(0, 1000);
  const PluginReply head = {.refused = 1, .bytes = why.size()};
  send(&head, sizeof head);
  send(why.data(), why.size());
  std::_Exit(EXIT_SUCCESS);
}

/// A plugin reads and writes where it likes, but not what we say to each other.
void take_standard_input() {
  asker = fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(nothing, STDIN_FILENO);
  close(nothing);
}

/// A plugin that never returns must not outlive the program that asked, nor what it has started.
void end_with_whoever_asks() {
  setpgid(0, 0);
  std::thread([] {
    pollfd input = {asker, POLLRDHUP, 0};
    while (poll(&input, 1, -1) < 0) continue;
    kill(0, SIGKILL);
  }).detach();
}

/// What a plugin dies of is told by the signal, with nobody in between, and leaves no file: there
/// may be hundreds.
void let_die_quietly() {
  for (const int deadly : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT}) std::signal(deadly, SIG_DFL);
  const rlimit no_core = {1, 1};  // to a program that takes cores 0 is no limit
  setrlimit(RLIMIT_CORE, &no_core);
}

/// The fault of dlopen, without the path that it begins with.
std::string fault_of_loading(const char* path) {
  std::string fault = dlerror();
  const std::string start = std::string(path) + ": ";
  return fault.starts_with(start) ? fault.substr(start.size()) : fault;
}

const rayaudit_plugin& loaded(const char* path) {
  void* const library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) refuse("cannot be loaded: " + fault_of_loading(path));
  const auto entry =
      reinterpret_cast<decltype(&rayaudit_plugin_entry)>(dlsym(library, RAYAUDIT_PLUGIN_ENTRY));
  if (entry == nullptr)
    refuse("is no plugin: it lacks the symbol " RAYAUDIT_PLUGIN_ENTRY
           ", which the macro RAYAUDIT_PLUGIN of rayaudit/plugin.h defines");
  const rayaudit_plugin* const plugin = entry();
  if (plugin == nullptr) refuse("is no plugin: its " RAYAUDIT_PLUGIN_ENTRY " returns null");
  if (plugin->version == 0 || plugin->version > RAYAUDIT_PLUGIN_VERSION)
    refuse("is of version " + std::to_string(plugin->version) +
           " of rayaudit/plugin.h; known here are those up to " +
           std::to_string(RAYAUDIT_PLUGIN_VERSION));
  return *plugin;
}

void require_sizes(const rayaudit_plugin& plugin) {
  struct Size {
    const char* what;
    std::uint32_t is, must_be;
  };
  for (const auto& [what, is, must_be] :
       {Size{"case", plugin.case_size, sizeof(rayaudit_case)},
        Size{"answer", plugin.answer_size, sizeof(rayaudit_answer)},
        Size{"subject", plugin.subject_size, sizeof(rayaudit_subject)}})
    if (is != must_be)
      refuse(std::string("has a rayaudit_") + what + " of " + std::to_string(is) +
             " bytes where version " + std::to_string(plugin.version) +
             " of rayaudit/plugin.h has " + std::to_string(must_be));
}

std::span<const rayaudit_subject> subjects_of(const rayaudit_plugin& plugin) {
  constexpr std::size_t most = 10'000;  // beyond, it is garbage
  if (plugin.count == 0 || plugin.subjects == nullptr) refuse("names no subjects");
  if (plugin.count > most) refuse("says that it has " + std::to_string(plugin.count) + " subjects");
  return {plugin.subjects, plugin.count};
}

std::array<rayaudit_batch, shape_count> batches_of(const rayaudit_subject& subject) {
  return {subject.disk, subject.sphere,          subject.cylinder,
          subject.cone, subject.capped_cylinder, subject.capped_cone};
}

/// Copies a word of a plugin; what is that word, and of which subject, is told where it does not
/// fit.
template <std::size_t size>
void copy(const char* word, char (&to)[size], const std::string& what) {
  if (word == nullptr) refuse("gives no " + what);
  const std::size_t length = strnlen(word, size);
  if (length == size)
    refuse("gives a " + what + " of more than " + std::to_string(size - 1) + " letters");
  std::memcpy(to, word, length);
}

PluginSubject told(const rayaudit_subject& subject, std::size_t place) {
  PluginSubject made = {};
  const std::string number = std::to_string(place + 1);
  copy(subject.name, made.name, "name of its subject " + number);
  copy(subject.format, made.format, "format of its subject " + number);
  if (subject.about != nullptr)
    copy(subject.about, made.about, "description of its subject " + number);
  made.convention = subject.convention;
  const auto batches = batches_of(subject);
  for (std::size_t shape = 0; shape < shape_count; ++shape)
    made.answers[shape] = batches[shape] != nullptr;
  return made;
}

std::string full_name(const rayaudit_subject& subject) {
  return std::string(subject.name) + '/' + subject.format;
}

rayaudit_batch batch_of(std::span<const rayaudit_subject> subjects, const PluginRequest& request) {
  const auto found = std::find_if(
      subjects.begin(), subjects.end(),
      [&](const rayaudit_subject& subject) { return full_name(subject) == request.subject; });
  return found == subjects.end() ? nullptr : batches_of(*found)[request.shape];
}

/// Asks for answers to cases, and tells how many nanoseconds they took. What is thrown at us is the
/// plugin's own end: SIGABRT.
double ask(rayaudit_batch batch, std::span<const rayaudit_case> cases,
           std::span<rayaudit_answer> answers) noexcept {
  using Clock = std::chrono::steady_clock;
  std::fill(answers.begin(), answers.end(), rayaudit_answer{});
  const Clock::time_point start = Clock::now();
  batch(cases.data(), cases.size(), answers.data());
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

}  // namespace

void serve_plugin(const char* path) {
  let_die_quietly();
  take_standard_input();
  end_with_whoever_asks();
  const rayaudit_plugin& plugin = loaded(path);
  require_sizes(plugin);
  const std::span<const rayaudit_subject> subjects = subjects_of(plugin);
  std::vector<PluginSubject> all;
  for (std::size_t i = 0; i < subjects.size(); ++i) all.push_back(told(subjects[i], i));
  reply(std::span<const PluginSubject>(all));
  std::vector<rayaudit_case> cases;
  std::vector<rayaudit_answer> answers;
  for (PluginRequest request; receive(&request, sizeof request);) {
    cases.resize(request.count);
    answers.resize(request.count);
    if (!receive(cases.data(), cases.size() * sizeof cases[0])) break;
    const rayaudit_batch batch = batch_of(subjects, request);
    if (batch == nullptr) refuse("does not have it");
    const std::size_t at_once = request.one_by_one ? 1 : cases.size();
    for (std::size_t i = 0; i < cases.size(); i += at_once) {
      const std::span said(answers.data() + i, at_once);
      const double took = ask(batch, {cases.data() + i, at_once}, said);
      reply(std::span<const rayaudit_answer>(said), took);
    }
  }
  // What it does at an exit is of no account here.
  std::_Exit(EXIT_SUCCESS);
}

}  // namespace rayaudit
