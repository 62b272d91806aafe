#pragma once

#include <chrono>
#include <cstddef>

#include "arcway/progress.h"

namespace arcway::internal::cli {

/// A line on standard error, if that is a terminal, that shows how far the work is; gone when the work is done. Nothing
/// is shown of what takes less than a fifth of a second.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Callback for executors; must not outlive this.
  [[nodiscard]] ProgressCallback callback();

 private:
  void show(const Progress& progress);

  bool is_terminal_;
  std::chrono::steady_clock::time_point next_;
  std::size_t shown_ = 0;  // characters on the line
};

}  // namespace arcway::internal::cli
