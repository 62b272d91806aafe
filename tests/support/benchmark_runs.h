#pragma once

#include <string>

namespace arcway::internal::report {

/// One run in a file of Google Benchmark, with its wall and processor time [s].
/// @param more  further fields, each after a comma.
inline std::string run_of_clocks(const std::string& name, double wall, double processor, const std::string& more = {}) {
  return R"({"name":")" + name + R"(","run_type":"iteration","iterations":1,"real_time":)" +
         std::to_string(wall * 1e9) + R"(,"cpu_time":)" + std::to_string(processor * 1e9) + R"(,"time_unit":"ns")" +
         more + "}";
}

/// One run whose wall and processor time are the same.
inline std::string run(const std::string& name, double seconds, const std::string& more = {}) {
  return run_of_clocks(name, seconds, seconds, more);
}

/// A file of runs, with commas between them.
inline std::string file_of(const std::string& runs) {
  return R"({"context":{"processor":"Some <CPU> & more","commit":"abc"},"benchmarks":[)" + runs + "]}";
}

}  // namespace arcway::internal::report
