#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

/// What /proc tells of processes.

/// The children of the first thread of a process.
inline std::vector<pid_t> children_of(pid_t parent) {
  const std::string id = std::to_string(parent);
  std::ifstream list("/proc/" + id + "/task/" + id + "/children");
  return {std::istream_iterator<pid_t>(list), {}};
}

/// Is it there, and not only waiting for somebody to hear of its end?
inline bool lives(pid_t process) {
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string id, name, state;
  return stat >> id >> name >> state && state != "Z" && state != "X";
}

/// The processes that live and have these words one after the other on their command line.
inline std::vector<pid_t> processes_with(const std::string& words) {
  std::vector<pid_t> all;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string id = entry.path().filename().string();
    if (id.find_first_not_of("0123456789") != id.npos) continue;
    std::ostringstream text;
    text << std::ifstream(entry.path() / "cmdline").rdbuf();
    std::string line = text.str();
    for (char& letter : line)
      if (letter == '\0') letter = ' ';
    const auto process = static_cast<pid_t>(std::stol(id));
    if (line.find(words) != line.npos && lives(process)) all.push_back(process);
  }
  return all;
}

template <class Condition>
bool comes_true(const Condition& condition) {
  for (int i = 0; i < 1000 && !condition(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return condition();
}
