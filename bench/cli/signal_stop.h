#pragma once

#include <stop_token>
#include <thread>

namespace arcway::internal::cli {

/// Turns Ctrl-C (SIGINT), SIGTERM and SIGHUP into a stop request while an object exists, so that what is finished can
/// be kept. Another signal ends the tool as usual, unless it comes within 0.3 s of the first. At most one object at a
/// time.
class SignalStop {
 public:
  SignalStop();
  SignalStop(const SignalStop&) = delete;
  SignalStop& operator=(const SignalStop&) = delete;
  ~SignalStop();

  /// Requested within some 20 ms of the signal.
  [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }
  /// The signal that came, or 0.
  [[nodiscard]] int signal() const;

 private:
  std::stop_source stop_;
  std::jthread watcher_;  // last, so that it ends first
};

}  // namespace arcway::internal::cli
