#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cli/refusal.hpp"

namespace rayaudit {

struct RanksModule;

/// So many processes mpirun has started as one program, this one among them; 1 where it has not.
int ranks_started();

/// Is this the one of them that speaks for all?
bool is_first_rank();

/// A sentence with rank and machine before it.
std::string told_by_rank(const std::string& sentence);

/// The processes that work on one run together: ranks, from 0 on.
class Ranks {
 public:
  /// Joins the others; the children that are started from then on are not taken for ranks. Throws
  /// Error where this build cannot.
  Ranks();
  /// Waits for the others, and takes leave of them.
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool is_first() const { return rank_ == 0; }

  /// Does on every rank what takes no long time. Where it fails on any of them, the first tells
  /// why, and it throws Refusal on all, with nothing left to say.
  void together(const std::function<void()>& work);

  /// Does on every rank what may take long. Where it fails, it is told at once and all ranks end.
  void apart(const std::function<void()>& work);

  /// Has the first rank take what each gives, in the order of ranks. Where it throws, throws
  /// Refusal on all.
  void gather(const std::string& given,
              const std::function<void(int rank, const std::string& bytes)>& take);

  /// Has the first rank do work, while the others wait; its exit code, on all of them; refused
  /// like work together.
  int by_first(const std::function<int()>& work);

 private:
  void send(int to, const std::string& bytes) const;
  std::string receive(int from) const;
  /// What the first rank has come to is what all have come to.
  int agreed(const std::optional<Refusal>& refusal, int code) const;

  const RanksModule* module_;
  int rank_ = 0, size_ = 1;
};

}  // namespace rayaudit
