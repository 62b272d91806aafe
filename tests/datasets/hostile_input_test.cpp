// The fuzz targets on the small worlds cut off at any byte and with bytes changed. An exception that a reader's header
// does not name ends the test.

#include <gtest/gtest.h>

#include <filesystem>

#include "arcway/datasets/file_io.h"
#include "arcway/datasets/read_map.h"
#include "tests/fuzz/targets.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

namespace fs = std::filesystem;

struct Sample {
  std::string name, bytes;
};

std::vector<Sample> samples() {
  std::vector<Sample> result;
  for (const auto& entry : fs::directory_iterator(fs::path(ARCWAY_SOURCE_DIR) / "tests/data"))
    if (entry.is_regular_file() && entry.path().extension() != ".md" && entry.path().stem() != "shared_poses")
      result.push_back({entry.path().filename().string(), read_file(entry.path())});
  EXPECT_GE(result.size(), 12u);
  return result;
}

TEST(HostileInput, EveryReaderSurvivesEverySampleCutOffAnywhere) {
  for (const Sample& sample : samples()) {
    for (const test::FuzzTarget& target : test::fuzz_targets()) {
      for (std::size_t size = 0; size <= sample.bytes.size(); ++size) {
        const std::string cut = sample.bytes.substr(0, size);  // a copy, so that a sanitizer sees its end
        EXPECT_NO_THROW(test::run_fuzz_target(target, cut)) << sample.name << ", " << target.name << ", " << size;
      }
    }
  }
}

TEST(HostileInput, EveryReaderSurvivesChangedBytes) {
  test::RandomInputs random(1);
  for (const Sample& sample : samples()) {
    for (const test::FuzzTarget& target : test::fuzz_targets()) {
      for (int round = 0; round < 150; ++round) {
        std::string bytes = sample.bytes;
        const auto place = [&] {
          return static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(bytes.size()) - 1));
        };
        for (std::int64_t changes = random.integer(1, 4); changes > 0; --changes) {
          switch (random.integer(0, 3)) {
            case 0:
              bytes[place()] = static_cast<char>(random.integer(0, 255));
              break;
            case 1:
              bytes[place()] = "0123456789-.,eE[]{}()<>\" \n"[random.integer(0, 25)];
              break;
            case 2:
              bytes.insert(place(), bytes.substr(place(), static_cast<std::size_t>(random.integer(1, 40))));
              break;
            default:
              bytes.erase(place(), static_cast<std::size_t>(random.integer(1, 10)));
              if (bytes.empty()) bytes = " ";
          }
        }
        EXPECT_NO_THROW(test::run_fuzz_target(target, bytes)) << sample.name << ", " << target.name << ", " << round;
      }
    }
  }
}

}  // namespace
}  // namespace arcway::internal
