#include "bench/cli/signal_stop.h"

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <ctime>

namespace arcway::internal::cli {
namespace {

constexpr std::array kStopSignals = {SIGHUP, SIGINT, SIGTERM};
/// Time between two looks for a signal [ms]; longer ones let a user wait.
constexpr std::chrono::milliseconds kPoll(20);

/// Signals that come within this time of the first are the same request [ns]: `timeout` sends two at once.
constexpr std::int64_t kSameRequest = 300'000'000;

volatile sig_atomic_t stop_signal = 0;
std::atomic<std::int64_t> first_signal_at = 0;  ///< monotonic [ns]; 0: none came
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "else a handler may not use it");
std::array<struct sigaction, kStopSignals.size()> handlers_before;

/// A handler: calls nothing but what is safe within one.
void remember_stop(int signal) {
  timespec time = {};
  clock_gettime(CLOCK_MONOTONIC, &time);
  const std::int64_t now = std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
  std::int64_t first = 0;
  if (first_signal_at.compare_exchange_strong(first, now)) {
    stop_signal = signal;
  } else if (now - first > kSameRequest) {
    ::signal(signal, SIG_DFL);
    raise(signal);
  }
}

}  // namespace

SignalStop::SignalStop() {
  stop_signal = 0;
  first_signal_at = 0;
  struct sigaction stop = {};
  stop.sa_handler = remember_stop;
  stop.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < kStopSignals.size(); ++i) {
    sigaction(kStopSignals[i], nullptr, &handlers_before[i]);
    if (handlers_before[i].sa_handler != SIG_IGN) sigaction(kStopSignals[i], &stop, nullptr);  // nohup ignores SIGHUP
  }
  watcher_ = std::jthread([this](const std::stop_token& end) {
    while (!end.stop_requested() && stop_signal == 0) std::this_thread::sleep_for(kPoll);
    if (stop_signal != 0) stop_.request_stop();
  });
}

SignalStop::~SignalStop() {
  for (std::size_t i = 0; i < kStopSignals.size(); ++i) sigaction(kStopSignals[i], &handlers_before[i], nullptr);
}

int SignalStop::signal() const { return stop_signal; }

}  // namespace arcway::internal::cli
