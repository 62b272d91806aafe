#pragma once

#include <unistd.h>

#include <cstdint>
#include <fstream>

namespace arcway::internal::bench {

/// Memory of this process that is resident [bytes]; 0 where the kernel does not tell.
inline std::int64_t resident_bytes() {
  std::ifstream pages("/proc/self/statm");
  std::int64_t size = 0, resident = 0;
  pages >> size >> resident;
  return pages ? resident * sysconf(_SC_PAGESIZE) : 0;
}

}  // namespace arcway::internal::bench
