#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace arcway::internal {

/// Items in a total order that the caller knows: insertion behind an item, removal, and search by a monotone property.
///
/// Blocks of up to 64 items lie below an array of blocks. Each step touches a few cache lines, and even a million items
/// move little memory.
class GapOrder {
 public:
  /// Inserts the first item into an empty order.
  void start(std::uint32_t item) {
    blocks_.push_back({1, 0, {item}});
    order_.push_back(0);
    set_block(item, 0);
  }

  void insert_behind(std::uint32_t item, std::uint32_t added) {
    std::uint32_t b = block_of_[item];
    if (blocks_[b].count == kCapacity) {
      split(b);
      b = block_of_[item];
    }
    Block& block = blocks_[b];
    const auto end = block.items.begin() + block.count;
    const auto place = std::find(block.items.begin(), end, item) + 1;
    std::move_backward(place, end, end + 1);
    *place = added;
    ++block.count;
    set_block(added, b);
  }

  void erase(std::uint32_t item) {
    const std::uint32_t b = block_of_[item];
    Block& block = blocks_[b];
    const auto end = block.items.begin() + block.count;
    const auto place = std::find(block.items.begin(), end, item);
    std::move(place + 1, end, place);
    if (--block.count > 0) return;
    order_.erase(order_.begin() + block.rank);
    for (std::uint32_t i = block.rank; i < order_.size(); ++i) blocks_[order_[i]].rank = i;
    free_.push_back(b);
  }

  /// The last item with the property, which must hold for the first item and for no item behind one without it.
  template <class Property>
  [[nodiscard]] std::uint32_t last_with(const Property& property) const {
    const auto block_has = [&](std::uint32_t b) { return property(blocks_[b].items[0]); };
    const std::uint32_t b = *(std::partition_point(order_.begin() + 1, order_.end(), block_has) - 1);
    const Block& block = blocks_[b];
    return *(std::partition_point(block.items.begin() + 1, block.items.begin() + block.count, property) - 1);
  }

 private:
  static constexpr std::uint32_t kCapacity = 64;
  struct Block {
    std::uint32_t count;
    std::uint32_t rank;  // in order_
    std::array<std::uint32_t, kCapacity> items;
  };

  void set_block(std::uint32_t item, std::uint32_t block) {
    if (item >= block_of_.size()) block_of_.resize(item + 1);
    block_of_[item] = block;
  }

  void split(std::uint32_t b) {
    std::uint32_t added = static_cast<std::uint32_t>(blocks_.size());
    if (free_.empty()) {
      blocks_.emplace_back();
    } else {
      added = free_.back();
      free_.pop_back();
    }
    Block& block = blocks_[b];
    Block& upper = blocks_[added];
    upper.count = kCapacity / 2;
    block.count = kCapacity - kCapacity / 2;
    for (std::uint32_t i = 0; i < upper.count; ++i) {
      upper.items[i] = block.items[block.count + i];
      block_of_[upper.items[i]] = added;
    }
    order_.insert(order_.begin() + block.rank + 1, added);
    for (std::uint32_t i = block.rank + 1; i < order_.size(); ++i) blocks_[order_[i]].rank = i;
  }

  std::vector<Block> blocks_;
  std::vector<std::uint32_t> order_;  // blocks
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> block_of_;  // by item
};

}  // namespace arcway::internal
