#include "core/base/block_pool.h"

#include <algorithm>
#include <utility>

namespace arcway::internal {

namespace {

constexpr std::size_t kMostGrowth = 3;  // by which arrays grow at most at once, rounding of lengths included

bool has_grown(std::size_t from, std::size_t to) { return to > from && to / kMostGrowth < from; }

}  // namespace

void* BlockPool::take(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  asked_ = bytes;
  for (std::size_t i = count_; i-- > 0;) {
    if (kept_[i].bytes != bytes) continue;
    used_bytes_ += bytes;
    return remove(i).memory;
  }
  return nullptr;
}

void BlockPool::add_used(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  used_bytes_ += bytes;
}

void BlockPool::give(void* memory, std::size_t bytes) noexcept {
  std::unique_lock lock(mutex_);
  used_bytes_ -= bytes;
  if (has_grown(bytes, std::exchange(asked_, 0))) {
    lock.unlock();
    return release_(memory, bytes);
  }
  kept_[count_++] = {memory, bytes};
  kept_bytes_ += bytes;
  while (count_ > kMostBlocks || kept_bytes_ > used_bytes_) {
    const Block oldest = remove(0);
    lock.unlock();
    release_(oldest.memory, oldest.bytes);
    lock.lock();
  }
}

BlockPool::Block BlockPool::remove(std::size_t at) {
  const Block block = kept_[at];
  std::move(kept_.begin() + at + 1, kept_.begin() + count_, kept_.begin() + at);
  --count_;
  kept_bytes_ -= block.bytes;
  return block;
}

}  // namespace arcway::internal
