#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "arcway/datasets/file_io.h"
#include "bench/report/document.h"

// What is committed under bench/results, and the tables made from it.
namespace arcway::internal::report {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = ARCWAY_SOURCE_DIR;

std::vector<fs::path> machines() {
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(kSource / "bench/results"))
    if (entry.is_directory()) folders.push_back(entry.path());
  return folders;
}

Inputs inputs_of(const fs::path& folder) {
  return {read_results(read_file(folder / "results.json"), "results.json"), std::nullopt,
          read_peer_results(read_file(folder / "peers.json"), "peers.json")};
}

TEST(KeptResults, MadeTheTablesOfTheReadmes) {
  for (const char* readme : {"README.md", "bench/README.md"}) {
    const std::string text = read_file(kSource / readme);
    ASSERT_NE(text.find("<!-- table "), std::string::npos) << readme;
    EXPECT_TRUE(std::ranges::any_of(machines(),
                                    [&](const fs::path& m) { return with_tables(text, inputs_of(m), readme) == text; }))
        << readme << ": the tables are not those of any machine; see \"Results kept\" in bench/README.md";
  }
}

TEST(KeptResults, MadeTheTablesOfTheStrategy) {
  const std::string text = read_file(kSource / "core/README.md");
  ASSERT_NE(text.find("<!-- table strategy -->"), std::string::npos);
  ASSERT_NE(text.find("<!-- table moves -->"), std::string::npos);
  EXPECT_TRUE(std::ranges::any_of(machines(), [&](const fs::path& m) {
    const char* name = fs::exists(m / "strategy.json") ? "strategy.json" : "results.json";
    const Inputs inputs{read_results(read_file(m / name), name), std::nullopt, std::nullopt};
    return with_tables(text, inputs, "core/README.md") == text;
  })) << "core/README.md: the tables are not those of any machine; see \"Results kept\" in bench/README.md";
}

TEST(KeptResults, NameNoHostAndNoFolder) {
  ASSERT_FALSE(machines().empty());
  for (const fs::path& folder : machines())
    for (const auto& entry : fs::directory_iterator(folder)) {
      const std::string text = read_file(entry.path());
      for (const char* trace : {"host_name", "\"executable\"", "/home/", "/root/", "/tmp/"})
        EXPECT_EQ(text.find(trace), std::string::npos) << entry.path() << " has " << trace;
    }
}

TEST(KeptResults, HaveNoFailure) {
  for (const fs::path& folder : machines()) {
    const Inputs inputs = inputs_of(folder);
    for (const Measurement& m : inputs.results.measurements)
      EXPECT_TRUE(m.error.empty() || m.left_out()) << m.name << ": " << m.error;
    for (const Duel& d : inputs.peers->duels)
      EXPECT_TRUE(d.error.empty() || d.error.starts_with("left out")) << d.task << ", " << d.world << ": " << d.error;
  }
}

}  // namespace
}  // namespace arcway::internal::report
