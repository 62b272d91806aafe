#include <benchmark/benchmark.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "arcway/datasets/file_io.h"
#include "bench/report/results.h"
#include "bench/suites/corruption.h"
#include "bench/suites/live_cycles.h"
#include "bench/suites/reporter.h"
#include "bench/suites/run_policy.h"
#include "bench/suites/suite.h"

namespace arcway::internal::bench {
namespace {

constexpr const char* kUsage =
    "arcway_bench [--study=check|quick|full] [--out=F.json [--update|--repeat]] [--corrupt] [--live-cycles=N]\n"
    "             [Google Benchmark's own arguments]\n"
    "--update keeps what the file has of other benchmarks. --repeat keeps all that it has, if it is there: the runs "
    "are\n"
    "further repetitions.\n"
    "--corrupt makes every implementation get one answer wrong, and is done if all benchmarks notice; with\n"
    "--study=check, as larger sizes check some answers only.\n"
    "--live-cycles=N drives N cycles in each benchmark Live, up to 1,000,000.\n"
    "Exit codes: 0 all answers right (--corrupt: all noticed to be wrong), 1 not so, 2 bad usage.\n";

struct Options {
  Study study = Study::kQuick;
  std::string out;
  bool update = false;
  bool repeat = false;
  bool corrupt = false;
};

constexpr const char* kStudyNames[] = {"check", "quick", "full"};

/// A number from 1 to 1,000,000; false if it is none.
bool take_cycles(const std::string& text) {
  constexpr std::size_t kMostDigits = 7, kMost = 1'000'000;
  if (text.empty() || text.size() > kMostDigits || text.find_first_not_of("0123456789") != std::string::npos)
    return false;
  live_cycles() = std::stoul(text);
  return live_cycles() >= 1 && live_cycles() <= kMost;
}

/// Takes the tool's own arguments; false if one is wrong. The others go on to Google Benchmark.
bool take_options(int argc, char** argv, Options& options, std::vector<std::string>& others) {
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--study=check") {
      options.study = Study::kCheck;
    } else if (argument == "--study=quick") {
      options.study = Study::kQuick;
    } else if (argument == "--study=full") {
      options.study = Study::kFull;
    } else if (argument == "--corrupt") {
      options.corrupt = true;
    } else if (argument == "--update") {
      options.update = true;
    } else if (argument == "--repeat") {
      options.repeat = true;
    } else if (argument.rfind("--out=", 0) == 0) {
      options.out = argument.substr(6);
    } else if (argument.rfind("--live-cycles=", 0) == 0) {
      if (!take_cycles(argument.substr(argument.find('=') + 1))) return false;
    } else if (argument.rfind("--benchmark_", 0) == 0) {
      others.push_back(with_unit(argument));
    } else {
      return false;
    }
  }
  return true;
}

std::string with_earlier(const Options& options, const std::string& earlier, const std::string& run) {
  if (options.update) return report::updated_results(earlier, run, options.out);
  return options.repeat ? report::repeated_results(earlier, run, options.out) : run;
}

int run(int argc, char** argv) {
  Options options;
  std::vector<std::string> others;
  const bool known = take_options(argc, argv, options, others);
  if (!known || (options.corrupt && options.study != Study::kCheck) ||
      ((options.update || options.repeat) && options.out.empty()) || (options.update && options.repeat)) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  if (options.repeat) options.repeat = std::filesystem::exists(options.out);
  const std::string earlier = options.update || options.repeat ? read_file(options.out) : std::string();
  std::vector<std::string> arguments = benchmark_arguments(options.study);
  arguments.insert(arguments.begin(), argv[0]);
  arguments.insert(arguments.end(), others.begin(), others.end());
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  auto count = static_cast<int>(pointers.size());

  add_context(kStudyNames[static_cast<int>(options.study)]);
  benchmark::Initialize(&count, pointers.data());
  set_corrupting(options.corrupt);
  if (options.corrupt) benchmark::ClearRegisteredBenchmarks();  // those that know nothing of it
  add_all_suites(options.study);
  Reporter reporter(true);
  if (benchmark::RunSpecifiedBenchmarks(&reporter) == 0) {
    std::fputs("arcway_bench: no benchmark of that name\n", stderr);
    return 2;
  }
  if (!options.out.empty()) write_file_atomically(options.out, with_earlier(options, earlier, reporter.json()));
  if (options.corrupt) {
    std::fprintf(stderr, "arcway_bench: %d noticed the wrong answer, %d did not\n", reporter.failures(),
                 reporter.successes());
    return reporter.successes() > 0 || reporter.failures() == 0 ? 1 : 0;
  }
  if (reporter.failures() > 0) std::fprintf(stderr, "arcway_bench: %d failed\n", reporter.failures());
  return reporter.failures() > 0 ? 1 : 0;
}

}  // namespace
}  // namespace arcway::internal::bench

int main(int argc, char** argv) {
  try {
    return arcway::internal::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "arcway_bench: %s\n", error.what());
  }
  return 2;
}
