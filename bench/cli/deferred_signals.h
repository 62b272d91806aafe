#pragma once

namespace arcway::internal::cli {

/// While one lives, signals that end the tool (of a terminal, of `kill`, of a pipe that nobody reads, of a limit of
/// processor time) wait. Its end lets the one that came take its course. One at a time.
class DeferredSignals {
 public:
  DeferredSignals();
  DeferredSignals(const DeferredSignals&) = delete;
  DeferredSignals& operator=(const DeferredSignals&) = delete;
  ~DeferredSignals();

  /// Whether one waits: then what takes long is to end.
  static bool arrived();
};

}  // namespace arcway::internal::cli
