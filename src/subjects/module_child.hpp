#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <mutex>
#include <span>
#include <string>

#include "subjects/module_message.hpp"
#include "subjects/subject.hpp"

namespace rayaudit {

/// A module in a process of its own, so that whatever it does to its process (a crash, a hang,
/// subnormals flushed to zero) it does not do to ours. The process is the program executed anew,
/// started when first asked, and ends with this or with our own process, however that ends.
class ModuleChild {
 public:
  /// The program must know the command serve-module. A child that neither takes nor says anything
  /// for as long as patience is killed.
  ModuleChild(std::filesystem::path program, std::filesystem::path module,
              std::chrono::milliseconds patience = std::chrono::seconds(10));
  ~ModuleChild();
  ModuleChild(const ModuleChild&) = delete;
  ModuleChild& operator=(const ModuleChild&) = delete;

  /// Answers cases, all of the shape, by a subject as the module names it; the nanoseconds that the
  /// answers alone took. From any thread, one batch at a time. Throws NoAnswer where none came, and
  /// from then on at once.
  double answer(const std::string& subject, std::size_t shape, std::span<const Case> cases,
                std::span<Answer> answers);

 private:
  struct Broken;

  void start();
  double ask(const std::string& subject, std::size_t shape, std::span<const Case> cases,
             std::span<Answer> answers);
  ModuleReply receive_reply();
  void send(const void* bytes, std::size_t size);
  void receive(void* bytes, std::size_t size);
  void wait_for(short event);
  [[noreturn]] void refuse_end();
  void end();

  const std::filesystem::path program_, module_;
  const std::chrono::milliseconds patience_;
  std::mutex mutex_;
  pid_t child_ = 0;
  int socket_ = -1;
  std::string broken_, broken_by_;  ///< what happened, and the subject that it happened to
};

}  // namespace rayaudit
