#pragma once

#include <barrier>
#include <cstddef>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "arcway/process_group.h"

namespace arcway::internal::test {

/// Runs `work` on as many threads as the process group is to have processes, each with its own rank.
inline void run_process_group(std::size_t size, const std::function<void(const ProcessGroup&)>& work) {
  struct Exchange {
    explicit Exchange(std::size_t size) : gifts(size), barrier(static_cast<std::ptrdiff_t>(size)) {}
    std::vector<std::string> gifts;
    std::barrier<> barrier;
  };
  class Member final : public ProcessGroup {
   public:
    Member(Exchange& exchange, std::size_t rank) : exchange_(exchange), rank_(rank) {}
    [[nodiscard]] std::size_t size() const override { return exchange_.gifts.size(); }
    [[nodiscard]] std::size_t rank() const override { return rank_; }
    [[nodiscard]] std::vector<std::string> gather(std::string bytes) const override {
      exchange_.gifts[rank_] = std::move(bytes);
      exchange_.barrier.arrive_and_wait();
      std::vector<std::string> all = exchange_.gifts;
      exchange_.barrier.arrive_and_wait();
      return all;
    }

   private:
    Exchange& exchange_;
    std::size_t rank_;
  };
  Exchange exchange(size);
  std::vector<std::thread> threads;
  for (std::size_t rank = 0; rank < size; ++rank) threads.emplace_back([&, rank] { work(Member(exchange, rank)); });
  for (std::thread& thread : threads) thread.join();
}

}  // namespace arcway::internal::test
