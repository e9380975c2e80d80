#include <boost/test/unit_test.hpp>

#include "tests/cli/shell.hpp"

using shell::contains;
using shell::refused;
using shell::run;

namespace {

/// A copy of the program without the module beside it, as mpirun would start its rank.
shell::Ended by_rank(const std::string& variables) {
  return run("cp \"$RAYAUDIT\" alone\n" + variables +
             " ./alone audit textbook/float --cases 10 --report csv");
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_build_without_mpi_says_so_under_mpirun) {
  const std::string sentence =
      "mpirun has started 4 processes, but this rayaudit was built without MPI: there is no "
      "rayaudit-mpi.so beside it";
  BOOST_TEST(by_rank("OMPI_COMM_WORLD_SIZE=4 OMPI_COMM_WORLD_RANK=0") == refused(2, sentence));
  BOOST_TEST(by_rank("PMI_SIZE=4 PMI_RANK=0") == refused(2, sentence));
  BOOST_TEST(by_rank("SLURM_STEP_NUM_TASKS=4 PMIX_RANK=0") == refused(2, sentence));
  // Where mpirun has not ended it by then, the first has no such trouble.
  const auto other = by_rank("OMPI_COMM_WORLD_SIZE=4 OMPI_COMM_WORLD_RANK=3");
  BOOST_TEST(other.code == 2);
  BOOST_TEST(other.err.starts_with("rayaudit: rank 3 of 4 on "), other);
  BOOST_TEST(contains(other.err, ": " + sentence + "\n"), other);
}

BOOST_AUTO_TEST_CASE(one_process_needs_no_mpi) {
  const auto plain = by_rank("");
  BOOST_TEST(plain.code == 0, plain);
  BOOST_TEST((by_rank("OMPI_COMM_WORLD_SIZE=1 OMPI_COMM_WORLD_RANK=0") == plain));
  // srun starts four programs that have nothing to do with each other.
  BOOST_TEST((by_rank("SLURM_STEP_NUM_TASKS=4 SLURM_PROCID=2") == plain));
}
