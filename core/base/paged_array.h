#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace arcway::internal {

/// An array that takes memory page by page, where elements are first written; others are T(). A short search on a large
/// map then does not wait until the system has cleared memory for all of the map.
template <class T>
class PagedArray {
 public:
  /// Makes room for elements 0 to size - 1, without their memory. Those that are there stay.
  void make_room(std::size_t size) {
    if (pages_.size() * kPage < size) pages_.resize((size + kPage - 1) / kPage);
  }
  /// Makes room for elements 0 to size - 1, and takes their memory.
  void warm_up(std::size_t size) {
    make_room(size);
    for (auto& page : pages_)
      if (!page) page = std::make_unique<Page>();
  }
  /// Sets all elements to T().
  void clear() {
    for (auto& page : pages_)
      if (page) page->fill(T());
  }
  /// The element at an index for which there is room; null if its page has not been written to.
  [[nodiscard]] const T* find(std::size_t index) const {
    const Page* const page = pages_[index / kPage].get();
    return page != nullptr ? &(*page)[index % kPage] : nullptr;
  }
  /// The element at an index for which there is room, to be written.
  [[nodiscard]] T& operator[](std::size_t index) {
    auto& page = pages_[index / kPage];
    if (!page) page = std::make_unique<Page>();
    return (*page)[index % kPage];
  }

 private:
  static constexpr std::size_t kPageBytes = 4096;  // as those of most systems
  static constexpr std::size_t kPage = std::max<std::size_t>(kPageBytes / sizeof(T), 1);
  using Page = std::array<T, kPage>;

  std::vector<std::unique_ptr<Page>> pages_;  // null: not written to
};

}  // namespace arcway::internal
