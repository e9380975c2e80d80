#pragma once

#include <cstddef>

namespace rayaudit {

/// All of MPI that the program needs, as the module rayaudit-mpi.so does it; it is loaded only
/// where mpirun has started the program, for MPI's libraries take their time to load.
struct RanksModule {
  /// Joins the other processes; tells which of how many this one is.
  void (*begin)(int* rank, int* ranks);
  /// Both sleep until the other is there, which may be at work for hours.
  void (*send)(int to, const void* bytes, std::size_t size);
  void (*receive)(int from, void* bytes, std::size_t size);
  /// Ends all processes at once; does not return.
  void (*abort)(int code);
  /// Takes leave of the others, once all of them do.
  void (*end)();
};

/// The one name that the module shows: that of a RanksModule.
inline constexpr const char* name_of_ranks_module = "rayaudit_ranks";

}  // namespace rayaudit
