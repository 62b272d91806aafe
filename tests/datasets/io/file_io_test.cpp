#include "arcway/datasets/file_io.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <string>

namespace arcway::internal {
namespace {

namespace fs = std::filesystem;

class FileIoTest : public ::testing::Test {
 protected:
  FileIoTest() { fs::create_directories(folder_); }
  ~FileIoTest() override { fs::remove_all(folder_); }
  fs::path folder_ = fs::path(::testing::TempDir()) /
                     ("arcway_file_io_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(FileIoTest, WritesReplacesAndLeavesNothingBehind) {
  const std::string large(300000, 'x');
  write_file_atomically(folder_ / "a", "short");
  write_file_atomically(folder_ / "a", large);
  EXPECT_EQ(read_file(folder_ / "a"), large);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(FileIoTest, MakesFoldersWithThoseAbove) {
  make_folders(folder_ / "a" / "b");
  make_folders(folder_ / "a" / "b");
  EXPECT_TRUE(fs::is_directory(folder_ / "a" / "b"));
}

TEST_F(FileIoTest, LinksStay) {
  write_file_atomically(folder_ / "there", "old");
  fs::create_symlink("there", folder_ / "link");
  fs::create_symlink("not yet", folder_ / "to_nothing");
  for (const char* name : {"link", "to_nothing"}) {
    write_file_atomically(folder_ / name, "new");
    EXPECT_TRUE(fs::is_symlink(folder_ / name)) << name;
    EXPECT_EQ(read_file(folder_ / fs::read_symlink(folder_ / name)), "new");
  }
  fs::create_symlink("circle", folder_ / "circle");
  EXPECT_THROW(write_file_atomically(folder_ / "circle", ""), FileError);
}

TEST_F(FileIoTest, ReadsNoMoreThanALimit) {
  write_file_atomically(folder_ / "a", "12345");
  EXPECT_EQ(read_file(folder_ / "a", 5), "12345");
  EXPECT_THROW(static_cast<void>(read_file(folder_ / "a", 4)), FileError);
  fs::resize_file(folder_ / "a", std::uintmax_t{1} << 40);  // a file with a hole takes no room
  EXPECT_THROW(static_cast<void>(read_file(folder_ / "a")), FileError);
  EXPECT_EQ(read_file("/dev/null"), "");
  EXPECT_THROW(static_cast<void>(read_file("/dev/zero")), FileError);
  EXPECT_NE(read_file("/proc/self/stat"), "");  // which does not know its size
}

TEST_F(FileIoTest, ErrorsNameThePath) {
  const auto error = [](auto action) -> std::string {
    try {
      action();
    } catch (const FileError& e) {
      return e.what();
    }
    return "no error";
  };
  const std::string missing = (folder_ / "no" / "a").string();
  EXPECT_EQ(error([&] { static_cast<void>(read_file(missing)); }),
            "cannot read " + missing + ": No such file or directory");
  EXPECT_EQ(error([&] { write_file_atomically(missing, ""); }),
            "cannot write " + missing + ": No such file or directory");
  write_file_atomically(folder_ / "a", "");
  EXPECT_EQ(error([&] { make_folders(folder_ / "a" / "b"); }),
            "cannot make folder " + (folder_ / "a" / "b").string() + ": Not a directory");
  EXPECT_NE(error([&] { static_cast<void>(read_file(folder_)); }).find("cannot read"), std::string::npos);
  EXPECT_NE(error([&] { write_file_atomically(folder_, ""); }).find("cannot write"), std::string::npos);
}

}  // namespace
}  // namespace arcway::internal
