#pragma once

#include <array>
#include <cstddef>
#include <mutex>

namespace arcway::internal {

/// Memory of large arrays that are gone, kept for the next ones of the same length. The system gives fresh memory page
/// by page, and zeroes each: that took half of the time in which a planner of 100,004 vertices follows one moved
/// obstacle. What an array leaves that has just grown is not kept: hardly anything has that length again. What is kept
/// is never more than what is in use. Thread-safe.
class BlockPool {
 public:
  /// Gives a block back to the system.
  using Release = void (*)(void* memory, std::size_t bytes) noexcept;

  explicit constexpr BlockPool(Release release) : release_(release) {}
  BlockPool(const BlockPool&) = delete;
  BlockPool& operator=(const BlockPool&) = delete;

  /// A kept block of so many bytes, with what was last written there; null if there is none.
  void* take(std::size_t bytes);
  /// Counts a block in use that was not taken from here.
  void add_used(std::size_t bytes);
  /// Keeps a block that is no longer in use, or releases it and others.
  void give(void* memory, std::size_t bytes) noexcept;

 private:
  static constexpr std::size_t kMostBlocks = 256;  // some planners' worth; each is compared when a block is asked for

  struct Block {
    void* memory;
    std::size_t bytes;
  };
  // Takes out the block at a place; the others keep their order.
  Block remove(std::size_t at);

  const Release release_;
  std::mutex mutex_;
  std::array<Block, kMostBlocks + 1> kept_{};  // the oldest first
  std::size_t count_ = 0, kept_bytes_ = 0, used_bytes_ = 0;
  std::size_t asked_ = 0;  // length of the block that was asked for since the last one came back
};

}  // namespace arcway::internal
