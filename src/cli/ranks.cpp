#include "cli/ranks.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <vector>

#include "cli/output.hpp"
#include "cli/ranks_module.hpp"
#include "geometry/error.hpp"
#include "subjects/plugins.hpp"

namespace rayaudit {
namespace {

struct Started {
  int rank, ranks;
};

/// What whoever starts ranks tells them of it.
Started read_started() {
  constexpr std::array variables = {
      std::array{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},  // Open MPI's mpirun
      std::array{"PMI_RANK", "PMI_SIZE"},                          // MPICH's; srun --mpi=pmi2
      std::array{"PMIX_RANK", "SLURM_STEP_NUM_TASKS"}};            // srun --mpi=pmix
  for (const auto& [of_rank, of_ranks] : variables) {
    const char *rank = std::getenv(of_rank), *ranks = std::getenv(of_ranks);
    if (rank != nullptr && ranks != nullptr) return {std::atoi(rank), std::atoi(ranks)};
  }
  return {0, 1};
}

/// Read once: Ranks takes it out of the environment.
const Started& started() {
  static const Started told = read_started();
  return told;
}

const RanksModule& loaded_module() {
  const std::optional<std::filesystem::path> file = plugin_beside(this_program, "mpi");
  if (!file)
    throw Error(fmt::format(
        "mpirun has started {} processes, but this rayaudit was built without MPI: there is no "
        "rayaudit-mpi.so beside it",
        ranks_started()));
  // MPI loads parts of itself, which look for its names among those that all may see.
  void* const module = dlopen(file->c_str(), RTLD_NOW | RTLD_GLOBAL);
  const void* const ranks = module == nullptr ? nullptr : dlsym(module, name_of_ranks_module);
  if (ranks == nullptr) throw Error(fmt::format("MPI cannot be loaded: {}", dlerror()));
  return *static_cast<const RanksModule*>(ranks);
}

/// A child that found these would take itself for a rank.
void clear_environment() {
  constexpr std::array<std::string_view, 8> starts = {"OMPI_", "OPAL_", "ORTE_",     "PRTE_",
                                                      "PMIX_", "PMI_",  "MPI_LOCAL", "HYD"};
  std::vector<std::string> names;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    if (std::any_of(starts.begin(), starts.end(),
                    [&](std::string_view start) { return text.starts_with(start); }))
      names.emplace_back(text.substr(0, text.find('=')));
  }
  for (const std::string& name : names) unsetenv(name.c_str());
}

std::string name_of_machine() {
  std::array<char, 256> name = {};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "a machine without a name";
}

/// What work fails with, if it does.
std::optional<Refusal> refusal_of(const std::function<void()>& work) {
  try {
    work();
    return {};
  } catch (...) {
    return caught_refusal();
  }
}

}  // namespace

int ranks_started() { return started().ranks; }

bool is_first_rank() { return started().rank == 0; }

std::string told_by_rank(const std::string& sentence) {
  const auto [rank, ranks] = started();
  return fmt::format("rank {} of {} on {}: {}", rank, ranks, name_of_machine(), sentence);
}

Ranks::Ranks() : module_(&loaded_module()) {
  const int expected = ranks_started();
  module_->begin(&rank_, &size_);
  clear_environment();
  if (size_ == expected) return;
  module_->end();
  throw Error(
      fmt::format("mpirun has started {} processes, and the MPI that rayaudit was built with finds "
                  "{}: it needs its own mpirun",
                  expected, size_));
}

Ranks::~Ranks() { module_->end(); }

void Ranks::together(const std::function<void()>& work) {
  const std::optional<Refusal> ours = refusal_of(work);
  std::string said;
  if (ours)
    said =
        std::to_string(ours->code) + (is_first() ? ours->sentence : told_by_rank(ours->sentence));
  gather(said, [](int, const std::string& of_rank) {
    if (!of_rank.empty()) throw Refusal{static_cast<ExitCode>(of_rank[0] - '0'), of_rank.substr(1)};
  });
}

void Ranks::apart(const std::function<void()>& work) {
  const std::optional<Refusal> why = refusal_of(work);
  if (!why) return;
  complain(told_by_rank(why->sentence) + "; the run ends without a report");
  module_->abort(why->code);
}

void Ranks::gather(const std::string& given,
                   const std::function<void(int rank, const std::string& bytes)>& take) {
  if (!is_first()) {
    send(0, given);
    if (const int code = agreed({}, 0); code != all_held)
      throw Refusal{static_cast<ExitCode>(code), ""};
    return;
  }
  std::optional<Refusal> refusal;
  for (int rank = 0; rank < size_; ++rank) {  // all of them, for all wait until it is received
    const std::string bytes = rank == 0 ? given : receive(rank);
    if (!refusal) refusal = refusal_of([&] { take(rank, bytes); });
  }
  agreed(refusal, all_held);
}

int Ranks::by_first(const std::function<int()>& work) {
  int code = all_held;
  std::optional<Refusal> refusal;
  if (is_first()) refusal = refusal_of([&] { code = work(); });
  return agreed(refusal, code);
}

int Ranks::agreed(const std::optional<Refusal>& refusal, int code) const {
  if (refusal) code = refusal->code;
  if (!is_first()) {
    module_->receive(0, &code, sizeof code);
    return code;
  }
  // Once they know, they end, and mpirun may end us.
  if (refusal) complain(refusal->sentence);
  for (int rank = 1; rank < size_; ++rank) module_->send(rank, &code, sizeof code);
  if (refusal) throw Refusal{refusal->code, ""};
  return code;
}

void Ranks::send(int to, const std::string& bytes) const {
  const std::size_t size = bytes.size();
  module_->send(to, &size, sizeof size);
  module_->send(to, bytes.data(), size);
}

std::string Ranks::receive(int from) const {
  std::size_t size = 0;
  module_->receive(from, &size, sizeof size);
  std::string bytes(size, '\0');
  module_->receive(from, bytes.data(), size);
  return bytes;
}

}  // namespace rayaudit
