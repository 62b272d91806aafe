#include "accel/mpi/mpi_process_group.h"

#define OMPI_SKIP_MPICXX 1
#include <mpi.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

namespace arcway::internal {

namespace {

// Largest message in bytes; counts of MPI are of type int.
constexpr std::uint64_t kLargestMessage = std::uint64_t{1} << 30;

}  // namespace

MpiProcessGroup::MpiProcessGroup() {
  int started = 0;
  MPI_Initialized(&started);
  if (started) throw std::runtime_error("MPI has been started before");
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  int size = 0, rank = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  size_ = static_cast<std::size_t>(size);
  rank_ = static_cast<std::size_t>(rank);
}

MpiProcessGroup::~MpiProcessGroup() { MPI_Finalize(); }

std::vector<std::string> MpiProcessGroup::gather(std::string bytes) const {
  std::uint64_t own = bytes.size();
  std::vector<std::uint64_t> sizes(size_);
  MPI_Allgather(&own, 1, MPI_UINT64_T, sizes.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD);
  std::vector<std::string> all(size_);
  all[rank_] = std::move(bytes);
  for (std::size_t from = 0; from < size_; ++from) {
    all[from].resize(sizes[from]);
    for (std::uint64_t done = 0; done < sizes[from]; done += kLargestMessage)
      MPI_Bcast(all[from].data() + done, static_cast<int>(std::min(kLargestMessage, sizes[from] - done)), MPI_BYTE,
                static_cast<int>(from), MPI_COMM_WORLD);
  }
  return all;
}

void MpiProcessGroup::abort(int code) const {
  MPI_Abort(MPI_COMM_WORLD, code);
  std::abort();
}

}  // namespace arcway::internal
