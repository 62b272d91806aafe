#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace arcway::internal {

/// Pages of which most are never made. Copies share them; a page is copied when one of several owners writes to it.
/// Writing needs the copy to itself; different copies may be used at once.
template <class Page>
class SharedPages {
 public:
  /// No page from here on has been made.
  [[nodiscard]] std::size_t size() const { return pages_.size(); }
  /// A page, or null.
  [[nodiscard]] const Page* find(std::size_t i) const { return i < pages_.size() ? pages_[i].get() : nullptr; }
  /// A page to write to.
  [[nodiscard]] Page& own(std::size_t i) {
    if (i >= pages_.size()) pages_.resize(i + 1);
    std::shared_ptr<Page>& page = pages_[i];
    if (!page) {
      page = std::make_shared<Page>();
    } else if (page.use_count() > 1) {
      page = std::make_shared<Page>(*page);
    } else {
      std::atomic_thread_fence(std::memory_order_acquire);  // another owner that is gone may have read it last
    }
    return *page;
  }
  /// Takes another owner's page in place of one that was not made.
  void share(std::size_t i, const SharedPages& other) {
    if (i >= pages_.size()) pages_.resize(i + 1);
    pages_[i] = other.pages_[i];
  }

 private:
  std::vector<std::shared_ptr<Page>> pages_;
};

/// A set of numbers, a bit each where some are in it. Copies share what they have in common.
class MarkedNumbers {
 public:
  void mark(std::uint32_t n) { pages_.own(n / kInPage)[n % kInPage / kBits] |= bit(n); }
  /// Marks what is marked in another set.
  void mark_all_of(const MarkedNumbers& other) {
    for (std::size_t p = 0; p < other.pages_.size(); ++p) {
      const Page* const more = other.pages_.find(p);
      if (!more) continue;
      if (!pages_.find(p)) {
        pages_.share(p, other.pages_);
      } else {
        Page& page = pages_.own(p);
        for (std::size_t i = 0; i < page.size(); ++i) page[i] |= (*more)[i];
      }
    }
  }
  [[nodiscard]] bool has(std::uint32_t n) const {
    const Page* const page = pages_.find(n / kInPage);
    return page && ((*page)[n % kInPage / kBits] & bit(n)) != 0;
  }
  /// Those marked, ascending.
  [[nodiscard]] std::vector<std::uint32_t> all() const {
    std::vector<std::uint32_t> marked;
    for (std::size_t p = 0; p < pages_.size(); ++p) {
      const Page* const page = pages_.find(p);
      if (!page) continue;
      for (std::size_t i = 0; i < page->size(); ++i)
        for (std::uint64_t word = (*page)[i]; word != 0; word &= word - 1)
          marked.push_back(
              static_cast<std::uint32_t>(p * kInPage + i * kBits + static_cast<std::size_t>(std::countr_zero(word))));
    }
    return marked;
  }

 private:
  static constexpr std::size_t kInPage = 4096, kBits = 64;
  using Page = std::array<std::uint64_t, kInPage / kBits>;
  static std::uint64_t bit(std::uint32_t n) { return std::uint64_t{1} << (n % kBits); }

  SharedPages<Page> pages_;
};

/// Numbers by key, several a key at will, where few keys have any. Copies share what they have in common.
class SharedTable {
 public:
  struct Item {
    std::uint32_t key, number;
    friend auto operator<=>(const Item&, const Item&) = default;  // NOLINT(modernize-use-nullptr): <compare> has it
  };

  /// The items of a key.
  [[nodiscard]] std::span<const Item> of(std::uint32_t key) const {
    const Page* const page = pages_.find(key / kInPage);
    if (!page) return {};
    return {std::ranges::lower_bound(*page, key, {}, &Item::key), std::ranges::upper_bound(*page, key, {}, &Item::key)};
  }
  void add(std::uint32_t key, std::uint32_t number) {
    Page& page = pages_.own(key / kInPage);
    const Item item{key, number};
    page.insert(std::ranges::lower_bound(page, item), item);
  }
  /// Precondition: the item is there.
  void remove(std::uint32_t key, std::uint32_t number) {
    Page& page = pages_.own(key / kInPage);
    page.erase(std::ranges::lower_bound(page, Item{key, number}));
  }

 private:
  static constexpr std::size_t kInPage = 4096;  // keys
  using Page = std::vector<Item>;               // ascending

  SharedPages<Page> pages_;
};

}  // namespace arcway::internal
