#include "bench/cli/deferred_signals.h"

#include <array>
#include <csignal>
#include <cstddef>

namespace arcway::internal::cli {
namespace {

constexpr std::array kSignals = {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU};

volatile sig_atomic_t waiting = 0;  ///< the signal that came last
std::array<struct sigaction, kSignals.size()> before;

void remember(int signal) { waiting = signal; }

}  // namespace

DeferredSignals::DeferredSignals() {
  waiting = 0;
  struct sigaction later = {};
  later.sa_handler = remember;  // without SA_RESTART: what waits for a pipe's reader is to hear of it
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &before[i]);
    if (before[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &later, nullptr);  // nohup ignores SIGHUP
  }
}

DeferredSignals::~DeferredSignals() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before[i], nullptr);
  if (waiting != 0) raise(waiting);
}

bool DeferredSignals::arrived() { return waiting != 0; }

}  // namespace arcway::internal::cli
