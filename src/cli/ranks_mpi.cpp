#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "cli/ranks_module.hpp"

/// The only file that knows MPI: the module rayaudit-mpi.so. What MPI cannot do ends all processes,
/// with a message of its own.
namespace rayaudit {
namespace {

constexpr int tag = 0;

/// MPI itself would wait by turning round and round, on a processor that others could use.
void sleep_until_done(MPI_Request request) {
  int is_done = 0;
  for (;;) {
    MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
    if (is_done != 0) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// Counts are ints to MPI: calls transfer(place, count) for one piece after the other.
template <class Transfer>
void in_pieces(std::size_t size, const Transfer& transfer) {
  constexpr std::size_t largest = std::size_t{1} << 30;
  for (std::size_t place = 0; place < size; place += largest)
    sleep_until_done(transfer(place, static_cast<int>(std::min(largest, size - place))));
}

void begin(int* rank, int* ranks) {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, rank);
  MPI_Comm_size(MPI_COMM_WORLD, ranks);
}

void send(int to, const void* bytes, std::size_t size) {
  in_pieces(size, [&](std::size_t place, int count) {
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Isend(static_cast<const char*>(bytes) + place, count, MPI_BYTE, to, tag, MPI_COMM_WORLD,
              &request);
    return request;
  });
}

void receive(int from, void* bytes, std::size_t size) {
  in_pieces(size, [&](std::size_t place, int count) {
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Irecv(static_cast<char*>(bytes) + place, count, MPI_BYTE, from, tag, MPI_COMM_WORLD,
              &request);
    return request;
  });
}

void abort(int code) { MPI_Abort(MPI_COMM_WORLD, code); }

void end() { MPI_Finalize(); }

}  // namespace
}  // namespace rayaudit

extern "C" {
extern const rayaudit::RanksModule rayaudit_ranks __attribute__((visibility("default")));
const rayaudit::RanksModule rayaudit_ranks = {rayaudit::begin, rayaudit::send, rayaudit::receive,
                                              rayaudit::abort, rayaudit::end};
}
