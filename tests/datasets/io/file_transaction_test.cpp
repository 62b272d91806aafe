#include "datasets/io/file_transaction.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace arcway::internal {
namespace {

namespace fs = std::filesystem;

class FileTransactionTest : public ::testing::Test {
 protected:
  FileTransactionTest() {
    fs::create_directories(folder_);
    write_file_atomically(folder_ / "a", "old");
  }
  ~FileTransactionTest() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string text_of(const fs::path& name) const { return read_file(folder_ / name); }
  [[nodiscard]] std::ptrdiff_t entries() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }
  static std::string error_of(const auto& action) {
    try {
      action();
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  }
  void write(FileTransaction& files, const fs::path& name) const {
    files.claim(folder_ / name);
    files.put(folder_ / name, "new");
  }

  fs::path folder_ = fs::path(::testing::TempDir()) / ("arcway_transaction_" + std::to_string(getpid()));
};

TEST_F(FileTransactionTest, ReplacesAllFilesAndLeavesNothingBehind) {
  FileTransaction files;
  write(files, "a");
  write(files, "b");
  files.claim(folder_ / "unused");
  EXPECT_EQ(entries(), 1);
  EXPECT_EQ(text_of("a"), "old");
  files.commit();
  EXPECT_EQ(text_of("a") + text_of("b"), "newnew");
  EXPECT_EQ(entries(), 2);
}

TEST_F(FileTransactionTest, RefusesWhatCannotBeWrittenWhenItIsClaimed) {
  FileTransaction files;
  const auto claim = [&](const fs::path& path) { return error_of([&] { files.claim(path); }); };
  EXPECT_EQ(claim(folder_ / "no" / "b"),
            "cannot write " + (folder_ / "no" / "b").string() + ": No such file or directory");
  EXPECT_NE(claim(folder_ / "a" / "b").find("Not a directory"), std::string::npos);
  EXPECT_NE(claim(folder_).find("Is a directory"), std::string::npos);
  EXPECT_NE(claim(folder_ / "").find("Is a directory"), std::string::npos);
  EXPECT_NE(claim(folder_ / std::string(256, 'n')).find("File name too long"), std::string::npos);
  EXPECT_NE(claim("/proc/no_such_file"), "");
  EXPECT_EQ(entries(), 1);
  EXPECT_THROW(files.put(folder_ / "never claimed", ""), std::logic_error);
}

TEST_F(FileTransactionTest, AFailureLeavesAllFilesAsTheyWere) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  FileTransaction files;
  for (const fs::path& name : {fs::path("a"), fs::path("b"), fs::path("/dev/full")}) write(files, name);
  EXPECT_NE(error_of([&] { files.commit(); }).find("cannot write /dev/full: "), std::string::npos);
  EXPECT_EQ(text_of("a"), "old");
  EXPECT_EQ(entries(), 1);
}

// The last of three cannot be renamed any more: a folder has come in its place.
TEST_F(FileTransactionTest, GivesReplacedFilesTheirNamesBack) {
  FileTransaction files;
  for (const char* name : {"a", "b", "c"}) write(files, name);
  fs::create_directories(folder_ / "c" / "in_the_way");
  EXPECT_NE(error_of([&] { files.commit(); }).find("cannot write " + (folder_ / "c").string()), std::string::npos);
  EXPECT_EQ(text_of("a"), "old");
  EXPECT_FALSE(fs::exists(folder_ / "b"));
  EXPECT_EQ(entries(), 2);
}

TEST_F(FileTransactionTest, StopsWhenToldTo) {
  FileTransaction files;
  write(files, "a");
  EXPECT_NE(error_of([&] { files.commit([] { return true; }); }).find("Interrupted"), std::string::npos);
  EXPECT_EQ(text_of("a"), "old");
  EXPECT_EQ(entries(), 1);
}

TEST_F(FileTransactionTest, KnowsAFileByWhatItIs) {
  fs::create_hard_link(folder_ / "a", folder_ / "hard");
  fs::create_symlink("a", folder_ / "soft");
  fs::create_directory(folder_ / "sub");
  fs::create_directory_symlink(".", folder_ / "here");
  fs::create_symlink("later", folder_ / "to_later");
  const std::vector<std::vector<fs::path>> same = {{"a", "hard", "soft", "here/a", "sub/../a", "./a", "here/here/soft"},
                                                   {"later", "to_later", "here/later", "./later", "here/to_later"}};
  for (const std::vector<fs::path>& names : same)
    for (const fs::path& one : names)
      for (const fs::path& other : names) {
        SCOPED_TRACE(one.string() + " " + other.string());
        FileTransaction twice;
        twice.claim(folder_ / one);
        EXPECT_NE(error_of([&] { twice.claim(folder_ / other); }).find("two files of this name"), std::string::npos);
        FileTransaction before, after;
        before.protect(folder_ / one);
        after.claim(folder_ / other);
        const bool there = fs::exists(folder_ / one);
        EXPECT_EQ(error_of([&] { before.claim(folder_ / other); }).find("was read") != std::string::npos, there);
        EXPECT_EQ(error_of([&] { after.protect(folder_ / one); }).find("was read") != std::string::npos, there);
      }
  FileTransaction different;
  for (const char* name : {"a", "later", "sub/a", "sub/later", "latest"}) different.claim(folder_ / name);
}

TEST_F(FileTransactionTest, TakesTheLongestNames) {
  const std::string longest(255, 'n');
  for (int time = 0; time < 2; ++time) {
    FileTransaction files;
    write(files, longest);
    files.commit();
    EXPECT_EQ(text_of(longest), "new");
  }
  EXPECT_EQ(entries(), 2);
}

TEST_F(FileTransactionTest, KeepsTheModeOfAFile) {
  fs::permissions(folder_ / "a", fs::perms(0640));
  FileTransaction files;
  write(files, "a");
  files.commit();
  EXPECT_EQ(fs::status(folder_ / "a").permissions(), fs::perms(0640));
}

TEST_F(FileTransactionTest, WritesDevicesAndPipesAsTheyAre) {
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  FileTransaction files;
  for (int time = 0; time < 2; ++time) write(files, "/dev/null");
  write(files, "pipe");
  // Opened for both, so that neither end waits for the other.
  std::fstream pipe(folder_ / "pipe");
  ASSERT_TRUE(pipe);
  files.commit();
  std::string text(3, '\0');
  pipe.read(text.data(), 3);
  EXPECT_EQ(text, "new");
  EXPECT_TRUE(fs::is_fifo(folder_ / "pipe"));
}

}  // namespace
}  // namespace arcway::internal
