#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>

#include "core/base/huge_pages.h"

namespace arcway::internal {

/// A number of values. Each is made when first asked for, and kept until the cache is destroyed. Lock-free: if two
/// threads make the same value at once, one of the two is dropped. Making a value must therefore have no side effects,
/// and always the same result. An empty cache takes an eighth of a byte a value.
template <class Value>
class SlotCache {
 public:
  explicit SlotCache(std::size_t count) : chunks_((count + kSlots - 1) / kSlots) {}
  SlotCache(const SlotCache&) = delete;
  SlotCache& operator=(const SlotCache&) = delete;
  ~SlotCache() {
    for (const auto& place : chunks_) {
      const Chunk* const chunk = place.load(std::memory_order_relaxed);
      if (!chunk) continue;
      for (const auto& slot : chunk->slots) delete slot.load(std::memory_order_relaxed);
      delete chunk;
    }
  }

  /// The value of slot i, if it has been made.
  [[nodiscard]] const Value* find(std::size_t i) const {
    const Chunk* const chunk = chunks_[i / kSlots].load(std::memory_order_acquire);
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
    for (std::size_t c = 0; c < chunks_.size(); ++c) {
      const Chunk* const chunk = chunks_[c].load(std::memory_order_acquire);
      if (!chunk) continue;
      for (std::size_t i = 0; i < kSlots; ++i)
        if (const Value* value = chunk->slots[i].load(std::memory_order_acquire)) visit(c * kSlots + i, *value);
    }
  }

 private:
  static constexpr std::size_t kSlots = 64;  // of a chunk: circles of three obstacles of ten vertices
  struct Chunk {
    std::array<std::atomic<const Value*>, kSlots> slots{};
  };

  Chunk& chunk_of(std::size_t i) const {
    std::atomic<Chunk*>& place = chunks_[i / kSlots];
    Chunk* chunk = place.load(std::memory_order_acquire);
    if (chunk) return *chunk;
    auto made = std::make_unique<Chunk>();
    if (place.compare_exchange_strong(chunk, made.get(), std::memory_order_acq_rel)) return *made.release();
    return *chunk;
  }

  mutable HugeVector<std::atomic<Chunk*>> chunks_;
};

}  // namespace arcway::internal
