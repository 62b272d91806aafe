#include "accel/wedge/big_vector.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace arcway {

namespace {

constexpr std::size_t kPage = std::size_t{1} << 21;

}  // namespace

void* allocate_big(std::size_t bytes) {
  if (bytes < kPage) return ::operator new(bytes);
  void* const memory = ::operator new (bytes, std::align_val_t{kPage});
#ifdef __linux__
  madvise(memory, bytes / kPage * kPage, MADV_HUGEPAGE);  // nothing is lost if the advice is not taken
#endif
  return memory;
}

void free_big(void* memory, std::size_t bytes) {
  if (bytes < kPage) {
    ::operator delete(memory);
  } else {
    ::operator delete (memory, std::align_val_t{kPage});
  }
}

}  // namespace arcway
