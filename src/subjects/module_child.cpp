#include "subjects/module_child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

namespace rayaudit {
namespace {

std::string told_end(int status) {
  if (WIFSIGNALED(status)) {
    const char* name = sigabbrev_np(WTERMSIG(status));
    const std::string signal = name != nullptr ? std::string("SIG") + name : "a signal";
    return "was killed by " + signal +
           (WTERMSIG(status) == SIGILL ? ", an instruction that this processor may not have" : "");
  }
  return "ended with exit code " + std::to_string(WEXITSTATUS(status));
}

std::string seconds(std::chrono::milliseconds time) {
  std::string text = std::to_string(static_cast<double>(time.count()) / 1000);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text + " s";
}

/// Starts the program with nothing of ours but standard error; its standard input is the socket.
int spawn(const char* program, const char* module, int socket, pid_t& child) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
  // What a module prints is neither an answer nor a report.
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  std::string words[] = {"rayaudit", "serve-module", module};
  char* const arguments[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
  const int fault = posix_spawn(&child, program, &actions, &attributes, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return fault;
}

}  // namespace

/// What happened to the module, as a sentence about it goes on.
struct ModuleChild::Broken {
  std::string what;
};

ModuleChild::ModuleChild(std::filesystem::path program, std::filesystem::path module,
                         std::chrono::milliseconds patience)
    : program_(std::move(program)), module_(std::move(module)), patience_(patience) {}

ModuleChild::~ModuleChild() { end(); }

double ModuleChild::answer(const std::string& subject, std::size_t shape,
                           std::span<const Case> cases, std::span<Answer> answers) {
  const std::lock_guard lock(mutex_);
  if (broken_.empty()) {
    try {
      if (child_ == 0) start();
      return ask(subject, shape, cases, answers);
    } catch (const Broken& broken) {
      end();
      broken_ = broken.what, broken_by_ = subject;
    }
  }
  throw NoAnswer(subject + " does not answer: its module " + module_.string() + " " + broken_ +
                 (subject == broken_by_ ? "" : " when " + broken_by_ + " was asked"));
}

void ModuleChild::start() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw Broken{std::string("cannot be reached: ") + std::strerror(errno)};
  const int fault = spawn(program_.c_str(), module_.c_str(), ends[1], child_);
  close(ends[1]);
  socket_ = ends[0];
  if (fault != 0) {
    child_ = 0;
    throw Broken{"is left without a process: " + program_.string() + ": " + std::strerror(fault)};
  }
  receive_reply();
}

double ModuleChild::ask(const std::string& subject, std::size_t shape, std::span<const Case> cases,
                        std::span<Answer> answers) {
  ModuleRequest request = {{}, shape, cases.size()};
  subject.copy(request.subject, sizeof request.subject - 1);
  send(&request, sizeof request);
  send(cases.data(), cases.size_bytes());
  const ModuleReply reply = receive_reply();
  if (reply.bytes != cases.size() * sizeof(Answer)) throw Broken{"sent no answers but garbage"};
  receive(answers.data(), reply.bytes);
  if (std::any_of(answers.begin(), answers.end(),
                  [](const Answer& answer) { return answer.form > Answer::Form::yes; }))
    throw Broken{"sent an answer of no known form"};
  return reply.nanoseconds;
}

ModuleReply ModuleChild::receive_reply() {
  constexpr std::size_t longest_sentence = 4096;
  ModuleReply reply;
  receive(&reply, sizeof reply);
  const bool is_garbage = reply.signed_by != ModuleReply::sign || reply.refused > 1;
  if (is_garbage || (reply.refused == 1 && reply.bytes > longest_sentence))
    throw Broken{"sent no answers but garbage"};
  if (reply.refused == 0) return reply;
  std::string why(reply.bytes, ' ');
  receive(why.data(), why.size());
  throw Broken{why};
}

void ModuleChild::send(const void* bytes, std::size_t size) {
  const auto* next = static_cast<const char*>(bytes);
  while (size > 0) {
    wait_for(POLLOUT);
    // A child that is gone is told by the error, not by a signal that would end us.
    const ssize_t sent = ::send(socket_, next, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (sent <= 0) refuse_end();
    next += sent, size -= static_cast<std::size_t>(sent);
  }
}

void ModuleChild::receive(void* bytes, std::size_t size) {
  auto* next = static_cast<char*>(bytes);
  while (size > 0) {
    wait_for(POLLIN);
    const ssize_t got = recv(socket_, next, size, MSG_DONTWAIT);
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (got <= 0) refuse_end();
    next += got, size -= static_cast<std::size_t>(got);
  }
}

void ModuleChild::wait_for(short event) {
  pollfd socket = {socket_, event, 0};
  int ready = 0;
  do {
    ready = poll(&socket, 1, static_cast<int>(patience_.count()));
  } while (ready < 0 && errno == EINTR);
  if (ready == 0) throw Broken{"said nothing for " + seconds(patience_) + " and was killed"};
}

/// The socket is closed at its other end.
void ModuleChild::refuse_end() {
  // Its process is about to end, or hides that it lives on.
  int status = 0;
  pid_t ended = 0;
  const auto latest = std::chrono::steady_clock::now() + patience_;
  while ((ended = waitpid(child_, &status, WNOHANG)) == 0 &&
         std::chrono::steady_clock::now() < latest)
    usleep(1000);
  if (ended == 0) throw Broken{"closed its standard input"};
  child_ = 0;
  if (ended < 0) throw Broken{"ended, and its parent does not hear how"};  // SIGCHLD is ignored
  throw Broken{told_end(status)};
}

void ModuleChild::end() {
  if (child_ != 0) {
    kill(child_, SIGKILL);  // it has nothing to lose, and may hang
    while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) continue;
  }
  if (socket_ >= 0) close(socket_);
  child_ = 0, socket_ = -1;
}

}  // namespace rayaudit
