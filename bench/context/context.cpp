#include "bench/context/context.h"

#include <Eigen/Core>
#include <fstream>
#include <thread>

#include "build_info.h"

namespace arcway::internal::bench {
namespace {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

std::string instruction_set() {
#if defined(__AVX512F__)
  return "AVX-512";
#elif defined(__AVX2__)
  return "AVX2";
#elif defined(__AVX__)
  return "AVX";
#elif defined(__x86_64__)
  return "x86-64 (SSE2)";
#elif defined(__aarch64__)
  return "AArch64 (NEON)";
#else
  return "generic";
#endif
}

}  // namespace

std::vector<std::pair<std::string, std::string>> machine_and_build() {
  return {
      {"processor", processor()},
      {"cores", std::to_string(std::thread::hardware_concurrency())},
      {"instruction_set", instruction_set()},
      {"compiler", kCompiler},
      {"flags", kFlags},
      {"build_type", kBuildType},
      {"commit", kCommit},
      {"eigen", std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
                    std::to_string(EIGEN_MINOR_VERSION)},
#ifdef ARCWAY_BENCH_EMBREE
      {"embree", ARCWAY_BENCH_EMBREE},
      {"onetbb", ARCWAY_BENCH_TBB},
#endif
  };
}

}  // namespace arcway::internal::bench
