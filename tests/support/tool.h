#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace arcway::internal::test {

namespace fs = std::filesystem;

inline std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Everything of a batch's results but times.
inline std::string without_times(const std::string& csv) {
  std::string kept;
  for (std::size_t begin = 0; begin < csv.size();) {
    const std::size_t end = csv.find('\n', begin);
    const std::string line = csv.substr(begin, end - begin);
    if (line[0] != '#') kept += line.substr(0, line.rfind(',')) + "\n";
    begin = end + 1;
  }
  return kept;
}

inline constexpr const char* kOneBox =
    R"({"type":"FeatureCollection","properties":{"bounds":[0,0,60,60]},"features":[)"
    R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[)"
    R"([[20,20],[40,20],[40,40],[20,40],[20,20]]]}}]})";
inline constexpr const char* kAround = " --start 10,10,0 --goal 50,50,90deg";

/// A box in the middle of a bounded field; every test has a folder of its own.
class Tool : public testing::Test {
 protected:
  struct Run {
    int code = -1;
    std::string out, err;
  };

  void SetUp() override {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / ("arcway_cli_" + std::to_string(getpid()) + "_" + test.name());
    fs::create_directories(folder_);
    map_ = put("box.geojson", kOneBox);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::string put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return file(name);
  }
  std::string read(const std::string& name) const { return text_of(folder_ / name); }
  bool exists(const std::string& name) const { return fs::exists(folder_ / name); }

  Run run(const std::string& arguments) const { return run_command("\"" ARCWAY_TOOL "\" " + arguments); }
  Run run_command(const std::string& command) const {
    const int status = std::system((command + " >\"" + file("stdout") + "\" 2>\"" + file("stderr") + "\"").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("stdout"), read("stderr")};
  }

  void expect_bad_input(const std::string& arguments, const std::string& message) const {
    const Run result = run(arguments);
    EXPECT_EQ(result.code, 2) << arguments;
    EXPECT_EQ(result.out, "") << arguments;
    EXPECT_TRUE(result.err.starts_with("arcway: ")) << arguments << "\n" << result.err;
    EXPECT_NE(result.err.find(message), std::string::npos) << arguments << "\n" << result.err;
  }

  fs::path folder_;
  std::string map_;
};

}  // namespace arcway::internal::test
