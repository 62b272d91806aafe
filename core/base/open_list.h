#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "core/base/huge_pages.h"

namespace arcway::internal {

/// A priority queue as a heap with four children a node, which moves through less memory than a binary heap. Siblings
/// of 16 bytes share a cache line. Entries come off in the order of `before(a, b)`, found by argument-dependent lookup.
/// If that is a total order, the sequence depends on the entries alone.
template <class Entry>
class OpenList {
 public:
  [[nodiscard]] bool empty() const { return heap_.size() <= kRoot; }
  [[nodiscard]] std::size_t size() const { return empty() ? 0 : heap_.size() - kRoot; }
  /// Precondition: not empty.
  [[nodiscard]] const Entry& top() const { return heap_[kRoot]; }
  /// The first `count` entries of the heap in memory, or all if there are fewer. The first one is the top; the second
  /// to come off is one of its children.
  [[nodiscard]] std::span<const Entry> first_few(std::size_t count) const {
    return empty() ? std::span<const Entry>() : std::span(heap_).subspan(kRoot, std::min(count, size()));
  }
  void clear() { heap_.clear(); }
  void reserve(std::size_t count) { heap_.reserve(kRoot + count); }
  /// Empties the queue but keeps memory for `count` entries.
  void warm_up(std::size_t count) { empty_with_memory(heap_, kRoot + count); }

  void push(const Entry& entry) {
    if (heap_.empty()) heap_.assign(kRoot, entry);
    heap_.push_back(entry);
    rise(heap_.size() - 1);
  }

  /// Removes the first entry. Precondition: not empty.
  Entry pop() {
    const Entry first = top();
    const Entry last = heap_.back();
    heap_.pop_back();
    if (!empty()) {
      heap_[kRoot] = last;
      sink();
    }
    return first;
  }

  /// Removes the entries that fail a test.
  template <class Test>
  void keep_if(Test&& passes) {
    if (empty()) return;
    heap_.erase(std::remove_if(heap_.begin() + kRoot, heap_.end(), [&](const Entry& entry) { return !passes(entry); }),
                heap_.end());
    for (std::size_t i = kRoot + 1; i < heap_.size(); ++i) rise(i);
  }

 private:
  static constexpr std::size_t kChildren = 4;
  static constexpr std::size_t kRoot = 3;  // so that siblings begin at a multiple of 4; what is before it is not used

  static std::size_t parent_of(std::size_t i) { return (i - kChildren) / kChildren + kRoot; }
  static std::size_t first_child_of(std::size_t i) { return (i - kRoot) * kChildren + kChildren; }

  void rise(std::size_t i) {
    const Entry entry = heap_[i];
    for (; i > kRoot && before(entry, heap_[parent_of(i)]); i = parent_of(i)) heap_[i] = heap_[parent_of(i)];
    heap_[i] = entry;
  }

  void sink() {
    const Entry entry = heap_[kRoot];
    std::size_t i = kRoot;
    for (;;) {
      const std::size_t first = first_child_of(i);
      if (first >= heap_.size()) break;
      std::size_t least = first;
      if (first + kChildren <= heap_.size()) {  // in pairs, as which is the least cannot be foreseen
        const Entry* const child = heap_.data() + first;
        const std::size_t low = before(child[1], child[0]), high = 2 + before(child[3], child[2]);
        least += before(child[high], child[low]) ? high : low;
      } else {
        for (std::size_t k = first + 1; k < heap_.size(); ++k)
          if (before(heap_[k], heap_[least])) least = k;
      }
      if (!before(heap_[least], entry)) break;
      heap_[i] = heap_[least];
      i = least;
    }
    heap_[i] = entry;
  }

  HugeVector<Entry> heap_;
};

}  // namespace arcway::internal
