#include "subjects/serve_module.hpp"

#include <dlfcn.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "subjects/module.hpp"
#include "subjects/module_message.hpp"

namespace rayaudit {
namespace {

/// Does all of it come? Else whoever asks has gone.
bool receive(void* bytes, std::size_t size) {
  auto* next = static_cast<char*>(bytes);
  while (size > 0) {
    const ssize_t got = read(STDIN_FILENO, next, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    next += got, size -= static_cast<std::size_t>(got);
  }
  return true;
}

void send(const void* bytes, std::size_t size) {
  const auto* next = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t sent = write(STDIN_FILENO, next, size);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) std::_Exit(EXIT_FAILURE);
    next += sent, size -= static_cast<std::size_t>(sent);
  }
}

void reply(const void* bytes, std::size_t size, double nanoseconds = 0) {
  const ModuleReply head = {.bytes = size, .nanoseconds = nanoseconds};
  send(&head, sizeof head);
  send(bytes, size);
}

void refuse(std::string_view why) {
  why = why.substr(0, 1000);
  const ModuleReply head = {.refused = 1, .bytes = why.size()};
  send(&head, sizeof head);
  send(why.data(), why.size());
}

/// A module that never returns must not outlive the program that asked.
void end_with_whoever_asks() {
  std::thread([] {
    pollfd input = {STDIN_FILENO, POLLRDHUP, 0};
    while (poll(&input, 1, -1) < 0) continue;
    std::_Exit(EXIT_SUCCESS);
  }).detach();
}

/// The module, or null where it was refused.
const Module* loaded(const char* path) {
  void* const library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    refuse(std::string("cannot be loaded: ") + dlerror());
    return nullptr;
  }
  const auto entry = reinterpret_cast<ModuleEntry>(dlsym(library, module_entry));
  if (entry == nullptr) {
    refuse(std::string("is not one of rayaudit's: it lacks the symbol ") + module_entry);
    return nullptr;
  }
  const Module* const module = entry();
  if (module->version == module_version && module->case_size == sizeof(Case) &&
      module->answer_size == sizeof(Answer))
    return module;
  refuse("is of another version of rayaudit: build both anew");
  return nullptr;
}

ModuleBatch batch_of(const Module& module, const ModuleRequest& request) {
  const std::span subjects(module.subjects, module.count);
  const auto found =
      std::find_if(subjects.begin(), subjects.end(), [&](const ModuleSubject& subject) {
        return std::string_view(subject.name) == request.subject;
      });
  return found == subjects.end() ? nullptr : found->answer[request.shape];
}

}  // namespace

void serve_module(const char* path) {
  // What a module dies of is told by the signal, with nobody in between.
  for (const int deadly : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT}) std::signal(deadly, SIG_DFL);
  end_with_whoever_asks();
  const Module* const module = loaded(path);
  if (module == nullptr) return;
  reply(nullptr, 0);
  std::vector<Case> cases;
  std::vector<Answer> answers;
  for (ModuleRequest request; receive(&request, sizeof request);) {
    cases.resize(request.count);
    answers.resize(request.count);
    if (!receive(cases.data(), cases.size() * sizeof(Case))) return;
    const ModuleBatch batch = batch_of(*module, request);
    if (batch == nullptr) return refuse("does not have it");
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    batch(cases.data(), cases.size(), answers.data());
    const std::chrono::duration<double, std::nano> took = Clock::now() - start;
    reply(answers.data(), answers.size() * sizeof(Answer), took.count());
  }
}

}  // namespace rayaudit
