#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "subjects/plugin_message.hpp"
#include "subjects/subject.hpp"

namespace rayaudit {

/// How a child's answers to a request ended.
struct Asked {
  enum class End {
    answered,  ///< all answers came
    died,      ///< its process ended
    garbled,   ///< what came is no message of ours
    silent,    ///< nothing came for as long as it was given, and it was killed
  };

  End end = End::answered;
  std::size_t answers = 0;    ///< that came, from the first on
  double nanoseconds = 0;     ///< that these took
  int signal = 0;             ///< of one that died: which ended it, or 0
  std::string sentence = {};  ///< what happened, as a sentence about the plugin goes on
};

/// What a request is put to a plugin as: one batch, or case after case, each answer as it comes.
enum class Manner { at_once, one_by_one };

/// A plugin in a process of its own, so that whatever it does to its process (a crash, a hang,
/// subnormals flushed to zero) it does not do to ours. The process is the program executed anew,
/// started when first asked and again after an end, and ends with this or with our own process,
/// however that ends; so does what it starts, as long as that stays in its process group.
class PluginChild {
 public:
  /// What keeps the plugin from being loaded, as a sentence about it goes on.
  struct Unloaded {
    std::string sentence;
  };

  /// The program must know the command serve-plugin. A child that neither takes nor says anything
  /// for as long as patience is killed.
  PluginChild(std::filesystem::path program, std::filesystem::path plugin,
              std::chrono::milliseconds patience);
  ~PluginChild();
  PluginChild(const PluginChild&) = delete;
  PluginChild& operator=(const PluginChild&) = delete;

  /// What the plugin says of its subjects. Throws Unloaded.
  std::vector<PluginSubject> subjects();

  /// Asks a subject (name/format) for answers to cases, all of the shape and at least one. From any
  /// thread, one request at a time. Throws NoAnswer where the plugin cannot be loaded or lacks the
  /// subject.
  Asked ask(const std::string& subject, std::size_t shape, std::span<const Case> cases,
            std::span<Answer> answers, Manner manner);

  /// The same at once, for one who has no use for part of the answers: the nanoseconds that they
  /// took. Throws NoAnswer where not all came, and for the subject from then on at once.
  double answer(const std::string& subject, std::size_t shape, std::span<const Case> cases,
                std::span<Answer> answers);

 private:
  struct Broken;

  void start();
  void load();
  void require_child(const std::string& subject);
  void receive_answers(std::span<Answer> answers, Manner manner, Asked& asked);
  PluginReply receive_reply();
  void send(const void* bytes, std::size_t size);
  void receive(void* bytes, std::size_t size);
  void wait_for(short event);
  [[noreturn]] void tell_end();
  void end();

  const std::filesystem::path program_, plugin_;
  const std::chrono::milliseconds patience_;
  std::mutex mutex_;
  pid_t child_ = 0;
  int socket_ = -1;
  /// Did a child break off? What the next ones say on standard error is not passed on.
  bool has_broken_ = false;
  std::chrono::milliseconds patience_now_ = {};
  std::vector<PluginSubject> subjects_;
  std::map<std::string, std::string> broken_;  ///< subjects, and what happened to them
};

}  // namespace rayaudit
