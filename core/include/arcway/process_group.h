#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "arcway/export.h"

namespace arcway {

/// Processes that build one graph together. Each computes a share of the rows, then all exchange them. Every process
/// makes the same calls in the same order.
class ARCWAY_API ProcessGroup {
 public:
  virtual ~ProcessGroup() = default;
  [[nodiscard]] virtual std::size_t size() const = 0;
  [[nodiscard]] virtual std::size_t rank() const = 0;  ///< of this process, in [0, size())
  /// Gives `bytes` to all processes, and returns what all of them gave, in the order of their ranks. Waits for all.
  [[nodiscard]] virtual std::vector<std::string> gather(std::string bytes) const = 0;

  /// A share of `count` items: the range [begin, end). The shares of ascending ranks follow each other and differ in
  /// size by at most 1.
  struct Share {
    std::size_t begin, end;
  };
  [[nodiscard]] Share share_of(std::size_t count) const { return share_of(count, rank()); }
  [[nodiscard]] Share share_of(std::size_t count, std::size_t rank) const {
    const std::size_t each = count / size(), rest = count % size();
    const auto start = [&](std::size_t r) { return r * each + (r < rest ? r : rest); };
    return {start(rank), start(rank + 1)};
  }
};

/// A group of one process.
class ARCWAY_API SingleProcess final : public ProcessGroup {
 public:
  [[nodiscard]] std::size_t size() const override { return 1; }
  [[nodiscard]] std::size_t rank() const override { return 0; }
  [[nodiscard]] std::vector<std::string> gather(std::string bytes) const override {
    std::vector<std::string> all;
    all.push_back(std::move(bytes));
    return all;
  }
};

inline const SingleProcess kSingleProcess;

}  // namespace arcway
