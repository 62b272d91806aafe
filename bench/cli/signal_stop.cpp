#include "bench/cli/signal_stop.h"

#include <signal.h>

#include <array>
#include <chrono>
#include <cstddef>

namespace arcway::internal::cli {
namespace {

constexpr std::array kStopSignals = {SIGHUP, SIGINT, SIGTERM};
/// Time between two looks for a signal [ms]; longer ones let a user wait.
constexpr std::chrono::milliseconds kPoll(20);

volatile sig_atomic_t stop_signal = 0;
std::array<struct sigaction, kStopSignals.size()> handlers_before;

void remember_stop(int signal) { stop_signal = signal; }

}  // namespace

SignalStop::SignalStop() {
  stop_signal = 0;
  struct sigaction once = {};
  once.sa_handler = remember_stop;
  once.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  for (std::size_t i = 0; i < kStopSignals.size(); ++i) {
    sigaction(kStopSignals[i], nullptr, &handlers_before[i]);
    if (handlers_before[i].sa_handler != SIG_IGN) sigaction(kStopSignals[i], &once, nullptr);  // nohup ignores SIGHUP
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
