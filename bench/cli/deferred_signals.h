#pragma once

namespace arcway::internal::cli {

/// Defers signals that would end the tool while an object exists; its destructor delivers the signal that came. Covers
/// the signals of a terminal, of `kill`, of a closed pipe, and of a limit of processor time. At most one object at a
/// time.
class DeferredSignals {
 public:
  DeferredSignals();
  DeferredSignals(const DeferredSignals&) = delete;
  DeferredSignals& operator=(const DeferredSignals&) = delete;
  ~DeferredSignals();

  /// Whether a signal waits; then long work should end.
  static bool arrived();
};

}  // namespace arcway::internal::cli
