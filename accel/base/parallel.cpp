#include "arcway/accel/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace arcway {

namespace {

constexpr std::size_t kMaxThreads = 1024;

int concurrency_of(std::size_t threads) {
  if (threads < 1 || threads > kMaxThreads)
    throw std::invalid_argument("executor: " + std::to_string(threads) + " threads, must be 1 to " +
                                std::to_string(kMaxThreads));
  // TBB prints a warning beyond the allowed number.
  const std::size_t allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return static_cast<int>(std::min(threads, allowed));
}

}  // namespace

struct TbbExecutor::Arena {
  explicit Arena(std::size_t threads) : arena(concurrency_of(threads)) {}
  tbb::task_arena arena;
};

TbbExecutor::TbbExecutor() = default;
TbbExecutor::TbbExecutor(std::size_t threads) : arena_(std::make_unique<Arena>(threads)) {}
TbbExecutor::~TbbExecutor() = default;

void TbbExecutor::for_ranges(std::size_t count, std::size_t grain,
                             const std::function<void(std::size_t, std::size_t)>& body) const {
  if (count == 0) return;
  const auto run = [&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, std::max<std::size_t>(grain, 1)),
                      [&](const tbb::blocked_range<std::size_t>& range) { body(range.begin(), range.end()); });
  };
  if (arena_) {
    arena_->arena.execute(run);
  } else {
    run();
  }
}

std::size_t TbbExecutor::threads() const {
  return static_cast<std::size_t>(arena_ ? arena_->arena.max_concurrency() : tbb::this_task_arena::max_concurrency());
}

}  // namespace arcway
