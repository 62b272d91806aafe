#pragma once

#include <span>
#include <string>
#include <vector>

#include "bench/report/results.h"

namespace arcway::internal::report {

/// A benchmark is noisy if its wall time exceeds its processor time by more than this share, or its longest repetition
/// the shortest. The first says that other programs ran or that it waited, and is asked of one thread alone.
///
/// What is noisy is marked wherever its times are shown, and left out of fits.
inline constexpr double kMostNoise = 0.10;

/// The times that a report goes by [s]: processor times, which other programs hardly change. A wall time that is much
/// longer makes a benchmark noisy, so that they hide no waiting. Of several threads, and of series over threads, they
/// are wall times, as processor times hide a speedup.
const std::vector<double>& times_of(const Measurement& m);

/// Why a benchmark is noisy: "wall time 23 % above processor time, repetitions differ by 15 %". Empty if it is not.
std::string noise_of(const Measurement& m);

/// The repetitions of one task, as wall and processor times [s].
/// @param wall  may be empty if it is not known; not with `by_wall`.
/// @param by_wall  whether several threads took part.
std::string noise_of(std::span<const double> wall, std::span<const double> processor, bool by_wall);

/// A time, with a dagger behind it if it is noisy.
std::string marked(const std::string& time, bool is_noisy);

/// What the dagger means, for below a table.
std::string mark_meaning();

}  // namespace arcway::internal::report
