#include "subjects/plugin_child.hpp"

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
#include <optional>
#include <utility>

#include "geometry/flat_case.hpp"
#include "geometry/signal_name.hpp"
#include "subjects/ending.hpp"

namespace rayaudit {
namespace {

/// To load a plugin may take as long, though its answers may not.
constexpr std::chrono::milliseconds least_to_load = std::chrono::seconds(5);

/// How often a child that says nothing is looked after.
constexpr std::chrono::milliseconds between_looks(50);

/// Starts the program in a group of its own with nothing of ours but standard error, or not even
/// that; its standard input is the socket.
int spawn(const char* program, const char* plugin, int socket, bool is_silent, pid_t& child) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
  // What a plugin prints is neither an answer nor a report.
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  if (is_silent)
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  std::string words[] = {"rayaudit", "serve-plugin", plugin};
  char* const arguments[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
  const int fault = posix_spawn(&child, program, &actions, &attributes, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return fault;
}

/// Waits for the end of a process and of all in its group; its status, nothing where nobody hears.
std::optional<int> reap(pid_t child) {
  siginfo_t ended;
  while (waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT) < 0 && errno == EINTR)
    continue;
  kill(-child, SIGKILL);  // while its number is still its own
  int status = 0;
  pid_t heard = 0;
  while ((heard = waitpid(child, &status, 0)) < 0 && errno == EINTR) continue;
  return heard < 0 ? std::nullopt : std::optional(status);
}

/// Does the process end within a time? Who closes the socket is about to, or hides that it lives
/// on.
bool ends_within(pid_t child, std::chrono::milliseconds time) {
  const auto latest = std::chrono::steady_clock::now() + time;
  for (;;) {
    siginfo_t ended = {};
    const int fault = waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT | WNOHANG);
    if (fault != 0 || ended.si_pid != 0) return true;
    if (std::chrono::steady_clock::now() > latest) return false;
    usleep(200);
  }
}

}  // namespace

/// What happened to the child, which is then no more to be asked.
struct PluginChild::Broken {
  Asked::End end;
  std::string sentence;
  int signal = 0;
};

PluginChild::PluginChild(std::filesystem::path program, std::filesystem::path plugin,
                         std::chrono::milliseconds patience)
    : program_(std::move(program)), plugin_(std::move(plugin)), patience_(patience) {}

PluginChild::~PluginChild() { end(); }

std::vector<PluginSubject> PluginChild::subjects() {
  const std::lock_guard lock(mutex_);
  if (child_ == 0) start();
  return subjects_;
}

Asked PluginChild::ask(const std::string& subject, std::size_t shape, std::span<const Case> cases,
                       std::span<Answer> answers, Manner manner) {
  const std::lock_guard lock(mutex_);
  require_child(subject);
  PluginRequest request = {{}, shape, cases.size(), manner == Manner::one_by_one};
  subject.copy(request.subject, sizeof request.subject - 1);
  std::vector<rayaudit_case> flat_cases(cases.size());
  std::transform(cases.begin(), cases.end(), flat_cases.begin(),
                 [](const Case& question) { return flat(question); });
  Asked asked;
  try {
    send(&request, sizeof request);
    send(flat_cases.data(), flat_cases.size() * sizeof flat_cases[0]);
    receive_answers(answers.first(cases.size()), manner, asked);
  } catch (const Unloaded& refusal) {
    end();
    throw NoAnswer(subject + " does not answer: its plugin " + plugin_.string() + ' ' +
                   refusal.sentence);
  } catch (const Broken& broken) {
    end();
    has_broken_ = true;
    asked.end = broken.end;
    asked.signal = broken.signal;
    asked.sentence = broken.sentence;
  }
  return asked;
}

double PluginChild::answer(const std::string& subject, std::size_t shape,
                           std::span<const Case> cases, std::span<Answer> answers) {
  const auto refuse = [&](const std::string& what) {
    throw NoAnswer(subject + " does not answer: its plugin " + plugin_.string() + ' ' + what);
  };
  if (cases.empty()) return 0;
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = broken_.find(subject); known != broken_.end()) refuse(known->second);
  }
  const Asked asked = ask(subject, shape, cases, answers, Manner::at_once);
  if (asked.end == Asked::End::answered) return asked.nanoseconds;
  {
    const std::lock_guard lock(mutex_);
    broken_[subject] = asked.sentence;
  }
  refuse(asked.sentence);
  return 0;
}

void PluginChild::require_child(const std::string& subject) {
  try {
    if (child_ == 0) start();
  } catch (const Unloaded& why) {
    throw NoAnswer(subject + " does not answer: its plugin " + plugin_.string() + ' ' +
                   why.sentence);
  }
}

void PluginChild::start() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw Unloaded{std::string("cannot be reached: ") + std::strerror(errno)};
  const int fault = spawn(program_.c_str(), plugin_.c_str(), ends[1], has_broken_, child_);
  close(ends[1]);
  socket_ = ends[0];
  if (fault != 0) {
    child_ = 0;
    end();
    throw Unloaded{"is left without a process: " + program_.string() + ": " + std::strerror(fault)};
  }
  try {
    load();
  } catch (const Broken& broken) {
    end();
    throw Unloaded{broken.sentence + " while it was loaded"};
  } catch (const Unloaded&) {
    end();
    throw;
  }
}

void PluginChild::load() {
  patience_now_ = std::max(patience_, least_to_load);
  const PluginReply reply = receive_reply();
  if (reply.bytes % sizeof(PluginSubject) != 0) throw Broken{Asked::End::garbled, "sent garbage"};
  subjects_.resize(reply.bytes / sizeof(PluginSubject));
  receive(subjects_.data(), reply.bytes);
  patience_now_ = patience_;
}

void PluginChild::receive_answers(std::span<Answer> answers, Manner manner, Asked& asked) {
  const std::size_t at_once = manner == Manner::one_by_one ? 1 : answers.size();
  std::vector<rayaudit_answer> said(at_once);
  while (asked.answers < answers.size()) {
    const PluginReply reply = receive_reply();
    if (reply.bytes != at_once * sizeof said[0])
      throw Broken{Asked::End::garbled, "sent no answers but garbage"};
    receive(said.data(), reply.bytes);
    for (const rayaudit_answer& each : said) answers[asked.answers++] = from_flat(each);
    asked.nanoseconds += reply.nanoseconds;
  }
}

PluginReply PluginChild::receive_reply() {
  constexpr std::size_t longest_sentence = 4096;
  PluginReply reply;
  receive(&reply, sizeof reply);
  const bool is_garbage = reply.signed_by != PluginReply::sign || reply.refused > 1;
  if (is_garbage || (reply.refused == 1 && reply.bytes > longest_sentence))
    throw Broken{Asked::End::garbled, "sent no answers but garbage"};
  if (reply.refused == 0) return reply;
  std::string why(reply.bytes, ' ');
  receive(why.data(), why.size());
  throw Unloaded{why};
}

void PluginChild::send(const void* bytes, std::size_t size) {
  const auto* next = static_cast<const char*>(bytes);
  while (size > 0) {
    wait_for(POLLOUT);
    // A child that is gone is told by the error, not by a signal that would end us.
    const ssize_t sent = ::send(socket_, next, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (sent <= 0) tell_end();
    next += sent, size -= static_cast<std::size_t>(sent);
  }
}

void PluginChild::receive(void* bytes, std::size_t size) {
  auto* next = static_cast<char*>(bytes);
  while (size > 0) {
    wait_for(POLLIN);
    const ssize_t got = recv(socket_, next, size, MSG_DONTWAIT);
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (got <= 0) tell_end();
    next += got, size -= static_cast<std::size_t>(got);
  }
}

void PluginChild::wait_for(short event) {
  pollfd socket = {socket_, event, 0};
  const auto latest = std::chrono::steady_clock::now() + patience_now_;
  for (auto left = patience_now_; left.count() >= 0;
       left = std::chrono::ceil<std::chrono::milliseconds>(latest -
                                                           std::chrono::steady_clock::now())) {
    const int ready = poll(&socket, 1, static_cast<int>(std::min(left, between_looks).count()));
    if (ready > 0 || (ready < 0 && errno != EINTR)) return;
    // What it has started may hold the socket open beyond its end.
    if (ends_within(child_, {})) {
      // Between the look at the socket and the one at the child it may have said its last words.
      if (poll(&socket, 1, 0) > 0) return;
      tell_end();
    }
    if (left.count() == 0) break;
  }
  throw Broken{Asked::End::silent,
               "said nothing for " + seconds(patience_now_) + " and was killed"};
}

/// How the child ended, which has closed its end of the socket, or is about to.
void PluginChild::tell_end() {
  if (!ends_within(child_, patience_now_)) throw Broken{Asked::End::died, "closed its connection"};
  const std::optional<int> status = reap(std::exchange(child_, 0));
  if (!status) throw Broken{Asked::End::died, "ended, and its parent does not hear how"};
  throw Broken{Asked::End::died, told_end(*status), WIFSIGNALED(*status) ? WTERMSIG(*status) : 0};
}

void PluginChild::end() {
  if (child_ != 0) {
    kill(-child_, SIGKILL);  // it has nothing to lose, and may hang
    kill(child_, SIGKILL);   // where it has left its group
    reap(child_);
  }
  if (socket_ >= 0) close(socket_);
  child_ = 0, socket_ = -1;
}

}  // namespace rayaudit
