#include "bench/cli/progress_bar.h"

#include <unistd.h>

#include <cstdio>
#include <string>

#include "bench/cli/standard_streams.h"

namespace arcway::internal::cli {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kFirst = std::chrono::milliseconds(200);
constexpr auto kEvery = std::chrono::milliseconds(100);
constexpr std::size_t kWidth = 40;

}  // namespace

ProgressBar::ProgressBar() : is_terminal_(!is_quiet() && isatty(STDERR_FILENO) == 1), next_(Clock::now() + kFirst) {}

ProgressBar::~ProgressBar() {
  if (shown_ == 0) return;
  std::fprintf(stderr, "\r%*s\r", static_cast<int>(shown_), "");
  std::fflush(stderr);
}

ProgressCallback ProgressBar::callback() {
  if (!is_terminal_) return [](const Progress&) {};
  return [this](const Progress& progress) { show(progress); };
}

void ProgressBar::show(const Progress& progress) {
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + kEvery;
  const std::size_t filled = kWidth * progress.done / progress.total;
  std::string line = "[" + std::string(filled, '#') + std::string(kWidth - filled, '.') + "] " +
                     std::to_string(100 * progress.done / progress.total) + " % of " + progress.stage;
  const std::size_t length = line.size();
  line.append(shown_ > length ? shown_ - length : 0, ' ');
  std::fprintf(stderr, "\r%s", line.c_str());
  std::fflush(stderr);
  shown_ = length;
}

}  // namespace arcway::internal::cli
