#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace [[gnu::visibility("default")]] arcway {

/// A heap of entries with four children a node, which moves through less memory than one with two. Entries come off in
/// the order of `before(a, b)`, found by argument-dependent lookup; a total order makes it that of the entries alone.
template <class Entry>
class OpenList {
 public:
  [[nodiscard]] bool empty() const { return heap_.empty(); }
  [[nodiscard]] std::size_t size() const { return heap_.size(); }
  /// Precondition: not empty.
  [[nodiscard]] const Entry& top() const { return heap_.front(); }
  /// The first entry, and a few of which one is the second.
  [[nodiscard]] std::span<const Entry> first_few() const {
    return std::span(heap_).first(std::min(kChildren + 1, heap_.size()));
  }
  void clear() { heap_.clear(); }

  void push(const Entry& entry) {
    heap_.push_back(entry);
    rise(heap_.size() - 1);
  }

  /// Removes the first entry. Precondition: not empty.
  Entry pop() {
    const Entry first = heap_.front();
    const Entry last = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) {
      heap_.front() = last;
      sink();
    }
    return first;
  }

  /// Removes the entries that fail a test.
  template <class Test>
  void keep_if(Test&& passes) {
    std::erase_if(heap_, [&](const Entry& entry) { return !passes(entry); });
    for (std::size_t i = 1; i < heap_.size(); ++i) rise(i);
  }

 private:
  static constexpr std::size_t kChildren = 4;

  void rise(std::size_t i) {
    const Entry entry = heap_[i];
    for (; i > 0 && before(entry, heap_[(i - 1) / kChildren]); i = (i - 1) / kChildren)
      heap_[i] = heap_[(i - 1) / kChildren];
    heap_[i] = entry;
  }

  void sink() {
    const Entry entry = heap_.front();
    std::size_t i = 0;
    for (;;) {
      const std::size_t first = kChildren * i + 1;
      if (first >= heap_.size()) break;
      std::size_t least = first;
      for (std::size_t k = first + 1; k < std::min(first + kChildren, heap_.size()); ++k)
        if (before(heap_[k], heap_[least])) least = k;
      if (!before(heap_[least], entry)) break;
      heap_[i] = heap_[least];
      i = least;
    }
    heap_[i] = entry;
  }

  std::vector<Entry> heap_;
};

}  // namespace arcway
