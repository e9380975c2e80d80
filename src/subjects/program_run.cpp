#include "subjects/program_run.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <span>

#include "subjects/subject.hpp"

namespace rayaudit {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void throw_refused(const char* what, int reason) {
  throw NoAnswer(std::string("there is no ") + what + " for a program: " + std::strerror(reason));
}

/// What goes in comes out; both ends are ours until closed.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) throw_refused("pipe", errno);
  }
  ~Pipe() { close_out(), close_in(); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int out() const { return ends_[0]; }
  int in() const { return ends_[1]; }  ///< -1 once closed
  void close_out() { close(ends_[0]); }
  void close_in() { close(ends_[1]); }

 private:
  static void close(int& end) {
    if (end >= 0) ::close(end);
    end = -1;
  }

  std::array<int, 2> ends_;
};

/// A shell that becomes the command. Before, it leaves a watcher in its group of processes,
/// nobody's child, which ends the whole group when descriptor 3 ends: when we close it, or end
/// ourselves, however that comes.
constexpr const char* watched_shell =
    "( (read -r _ <&3; kill -s KILL 0) </dev/null >/dev/null 2>&1 & ); exec 3<&-; "
    "exec /bin/sh -c \"$0\"";

/// Starts the command in a group of its own, with nothing of ours but standard error.
int spawn(const std::string& command, const Pipe& input, const Pipe& output, const Pipe& lifeline,
          pid_t& child) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input.out(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output.in(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, lifeline.out(), STDERR_FILENO + 1);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 2);
  sigset_t none, pipe_signal;
  sigemptyset(&none);
  sigemptyset(&pipe_signal);
  sigaddset(&pipe_signal, SIGPIPE);
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &pipe_signal);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  std::string words[] = {"sh", "-c", watched_shell, command};
  char* const arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(),
                             nullptr};
  const int fault = posix_spawn(&child, "/bin/sh", &actions, &attributes, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return fault;
}

/// A write to a pipe that nobody reads any more is an error, and not a signal that ends us.
ssize_t write_unsignalled(int pipe, std::string_view text) {
  sigset_t pipe_signal, before;
  sigemptyset(&pipe_signal);
  sigaddset(&pipe_signal, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &pipe_signal, &before);
  const ssize_t written = write(pipe, text.data(), text.size());
  const int fault = errno;
  const timespec at_once = {};
  while (written < 0 && fault == EPIPE && sigtimedwait(&pipe_signal, nullptr, &at_once) < 0 &&
         errno == EINTR)
    continue;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = fault;
  return written;
}

/// A command that runs, and all that it starts in its group of processes.
class RunningProgram {
 public:
  RunningProgram(const std::string& command, std::string_view text) : unfed_(text) {
    // Whoever of the group loses its parent becomes our child, so that its end can be waited for.
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    const int fault = spawn(command, input_, output_, lifeline_, leader_);
    if (fault != 0) throw_refused("shell", fault);
    input_.close_out(), output_.close_in(), lifeline_.close_out();
    fcntl(input_.in(), F_SETFL, O_NONBLOCK);
    if (text.empty()) input_.close_in();
  }
  ~RunningProgram() {
    kill(-leader_, SIGKILL);
    while (waitpid(-leader_, nullptr, 0) > 0 || errno == EINTR) continue;
  }
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  ProgramEnd exchange(std::chrono::milliseconds patience,
                      const std::function<void(std::string_view)>& take) {
    while (is_open_) {
      std::array<pollfd, 2> ends = {pollfd{input_.in(), POLLOUT, 0},
                                    pollfd{output_.out(), POLLIN, 0}};
      if (!comes_in_time(ends, patience)) return {.is_hung = true, .is_fed = unfed_.empty()};
      if (ends[0].revents != 0) feed();
      if (ends[1].revents != 0) read_some(take);
    }
    input_.close_in();
    ProgramEnd end = {.is_hung = false, .is_fed = unfed_.empty()};
    end.is_hung = !ends_in_time(patience, end.status);
    return end;
  }

 private:
  static bool comes_in_time(std::span<pollfd> ends, std::chrono::milliseconds patience) {
    const Clock::time_point latest = Clock::now() + patience;
    for (;;) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(latest - Clock::now());
      const auto wait = std::max<std::int64_t>(left.count(), 0);
      const int ready = poll(ends.data(), ends.size(), static_cast<int>(wait));
      if (ready >= 0 || errno != EINTR) return ready > 0;
    }
  }

  void feed() {
    const ssize_t fed = write_unsignalled(input_.in(), unfed_.substr(0, 1 << 16));
    if (fed < 0 && (errno == EINTR || errno == EAGAIN)) return;
    if (fed > 0) unfed_.remove_prefix(static_cast<std::size_t>(fed));
    if (fed < 0 || unfed_.empty()) input_.close_in();
  }

  void read_some(const std::function<void(std::string_view)>& take) {
    std::array<char, 1 << 16> piece;
    const ssize_t got = read(output_.out(), piece.data(), piece.size());
    if (got < 0 && errno == EINTR) return;
    is_open_ = got > 0;
    if (got > 0) take({piece.data(), static_cast<std::size_t>(got)});
  }

  /// Does the command end? Where SIGCHLD is ignored nobody hears how: it counts as well.
  bool ends_in_time(std::chrono::milliseconds patience, int& status) const {
    const Clock::time_point latest = Clock::now() + patience;
    while (waitpid(leader_, &status, WNOHANG) == 0) {
      if (Clock::now() > latest) return false;
      usleep(500);
    }
    return true;
  }

  Pipe input_, output_, lifeline_;
  pid_t leader_ = 0;
  bool is_open_ = true;  ///< its standard output
  std::string_view unfed_;
};

}  // namespace

ProgramEnd run_program(const std::string& command, std::string_view text,
                       std::chrono::milliseconds patience,
                       const std::function<void(std::string_view)>& take) {
  return RunningProgram(command, text).exchange(patience, take);
}

}  // namespace rayaudit
