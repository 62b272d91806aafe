#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>

#include "core/base/huge_pages.h"

namespace arcway::internal {

/// A number of values. Each is made when first asked for, and kept until the cache is destroyed. Lock-free: if two
/// threads make the same value at once, one of the two is dropped. Making a value must therefore have no side effects,
/// and always the same result. An empty cache takes a byte for 512 values.
template <class Value>
class SlotCache {
 public:
  explicit SlotCache(std::size_t count) : blocks_((count + kBlockSlots - 1) / kBlockSlots) {}
  SlotCache(const SlotCache&) = delete;
  SlotCache& operator=(const SlotCache&) = delete;
  ~SlotCache() {
    for (const auto& of_block : blocks_) {
      const std::unique_ptr<const Block> block(of_block.load(std::memory_order_relaxed));
      if (!block) continue;
      for (const auto& of_chunk : block->chunks) {
        const std::unique_ptr<const Chunk> chunk(of_chunk.load(std::memory_order_relaxed));
        if (!chunk) continue;
        for (const auto& slot : chunk->slots) delete slot.load(std::memory_order_relaxed);
      }
    }
  }

  /// The value of slot i, if it has been made.
  [[nodiscard]] const Value* find(std::size_t i) const {
    const Block* const block = blocks_[i / kBlockSlots].load(std::memory_order_acquire);
    const Chunk* const chunk = block ? block->chunks[i / kSlots % kChunks].load(std::memory_order_acquire) : nullptr;
    return chunk ? chunk->slots[i % kSlots].load(std::memory_order_acquire) : nullptr;
  }

  /// The value of slot i.
  /// @param make  returns it as a unique_ptr<const Value>; called at most once by each caller.
  template <class Make>
  const Value& get(std::size_t i, Make&& make) const {
    if (const Value* known = find(i)) return *known;
    std::unique_ptr<const Value> made = make();
    const Value* other = nullptr;
    if (chunk_of(i).slots[i % kSlots].compare_exchange_strong(other, made.get(), std::memory_order_acq_rel))
      return *made.release();
    return *other;
  }

  /// Calls visit(i, value) for each value that has been made, by slot.
  template <class Visitor>
  void visit(Visitor&& visit) const {
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const Block* const block = blocks_[b].load(std::memory_order_acquire);
      if (!block) continue;
      for (std::size_t c = 0; c < kChunks; ++c) {
        const Chunk* const chunk = block->chunks[c].load(std::memory_order_acquire);
        if (!chunk) continue;
        for (std::size_t i = 0; i < kSlots; ++i)
          if (const Value* value = chunk->slots[i].load(std::memory_order_acquire))
            visit((b * kChunks + c) * kSlots + i, *value);
      }
    }
  }

 private:
  static constexpr std::size_t kSlots = 64;   // of a chunk: circles of three obstacles of ten vertices
  static constexpr std::size_t kChunks = 64;  // of a block
  static constexpr std::size_t kBlockSlots = kSlots * kChunks;
  struct Chunk {
    std::array<std::atomic<const Value*>, kSlots> slots{};
  };
  struct Block {
    std::array<std::atomic<Chunk*>, kChunks> chunks{};
  };

  // What a place points to, made first if need be.
  template <class Part>
  static Part& made_at(std::atomic<Part*>& place) {
    if (Part* known = place.load(std::memory_order_acquire)) return *known;
    auto made = std::make_unique<Part>();
    Part* other = nullptr;
    return place.compare_exchange_strong(other, made.get(), std::memory_order_acq_rel) ? *made.release() : *other;
  }
  Chunk& chunk_of(std::size_t i) const {
    return made_at(made_at(blocks_[i / kBlockSlots]).chunks[i / kSlots % kChunks]);
  }

  mutable HugeVector<std::atomic<Block*>> blocks_;
};

}  // namespace arcway::internal
