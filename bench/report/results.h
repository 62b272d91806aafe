#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace arcway::internal::report {

/// One benchmark with all its repetitions.
struct Measurement {
  std::string name;                        ///< "ReducedGraph/embree/obstacles:100"
  std::vector<double> wall_seconds;        ///< one answer, one value a repetition
  std::vector<double> cpu_seconds;         ///< processor time of all threads
  std::map<std::string, double> counters;  ///< medians over the repetitions
  std::string label;                       ///< the law that theory gives for a series; the slowest query
  std::string error;                       ///< why there are no times; empty if there are
  [[nodiscard]] bool left_out() const { return error.starts_with("left out: "); }
};

/// Machine and build, in the order of a file.
using Context = std::vector<std::pair<std::string, std::string>>;

/// The value of a key; empty if there is none.
std::string context_value(const Context& context, std::string_view key);

/// A file of results.
struct Results {
  std::string name;  ///< name of the file
  Context context;
  std::vector<Measurement> measurements;  ///< in the order of the file
};

/// Reads Google Benchmark's JSON; repetitions are gathered, its own aggregates passed over. Where a counter `batch`
/// says how many answers an iteration gives, times are for one of them.
/// @throws FormatError naming file and place.
Results read_results(std::string_view json, std::string_view name);

/// A benchmark's name without what Google Benchmark adds of clocks and repetitions.
std::string plain_name(std::string name);

/// An earlier file of Google Benchmark with the runs of a newer one: those of equal benchmarks are replaced, others are
/// added. The context stays the earlier one's; its key `updated_at` lists the commits of newer runs.
/// @throws FormatError naming file and place; also for files of two processors.
std::string updated_results(std::string_view earlier, std::string_view run, std::string_view name);
/// An earlier file of Google Benchmark with the runs of a newer one as further repetitions. Runs of two programs that
/// take turns can be compared on a machine that is faster at one time than at another.
/// @throws FormatError naming file and place; also for files of two processors or two commits.
std::string repeated_results(std::string_view earlier, std::string_view run, std::string_view name);

/// A measurement's place in its series: "ReducedGraph/embree/obstacles:100" is size 100 of the key "obstacles" in the
/// series "ReducedGraph/embree", of the stage "ReducedGraph" and the variant "embree".
struct SeriesPlace {
  std::string stage, variant, series, key;
  double size = 0.0;
};
/// Nothing found: empty key, the whole name as series.
SeriesPlace place_of(std::string_view name);

/// The measurements of a stage that have times, in the order of the file.
std::vector<const Measurement*> of_stage(const Results& results, std::string_view stage);

/// What a name says of threads, "/threads:2", anywhere in it; 1 otherwise.
std::size_t threads_of(std::string_view name);

}  // namespace arcway::internal::report
