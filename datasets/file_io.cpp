#include "datasets/file_io.h"

#include <cerrno>
#include <deque>
#include <fstream>
#include <random>
#include <system_error>

namespace arcway {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const char* action, const fs::path& path, int error) {
  throw FileError(std::string("cannot ") + action + " " + path.string() + ": " +
                  (error != 0 ? std::generic_category().message(error) : "unknown reason"));
}

// What a path stands for, there or not: links stay when it is written.
fs::path behind_links(fs::path path) {
  constexpr int kMostLinks = 40;
  const fs::path given = path;
  std::error_code error;
  for (int links = 0; fs::is_symlink(path, error); ++links) {
    if (links == kMostLinks) fail("write", given, ELOOP);
    const fs::path named = fs::read_symlink(path, error);
    if (error) fail("write", given, error.value());
    path = path.parent_path() / named;
  }
  return path;
}

void write_whole(const fs::path& path, std::string_view text) {
  errno = 0;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  if (!file) fail("write", path, errno);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file) fail("write", path, errno);
}

// A file that waits beside the one that it is to replace. Devices and pipes are written at once.
class PendingFile {
 public:
  PendingFile(const fs::path& path, std::string_view text) : path_(path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) fail("write", path, EISDIR);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
      write_whole(path, text);
      return;
    }
    target_ = behind_links(path);
    temporary_ = target_;
    temporary_ += ".tmp" + std::to_string(std::random_device()());
    try {
      write_whole(temporary_, text);
    } catch (const FileError&) {
      const int reason = errno;
      fs::remove(temporary_, error);
      fail("write", path, reason);
    }
    if (fs::exists(status)) fs::permissions(temporary_, status.permissions(), error);
  }
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile() {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
  }

  void commit() {
    if (temporary_.empty()) return;
    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) fail("write", path_, error.value());
    temporary_.clear();
  }

 private:
  fs::path path_, target_, temporary_;
};

}  // namespace

std::string read_file(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) fail("read", path, EISDIR);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) fail("read", path, errno);
  std::string text;
  const std::uintmax_t size = fs::is_regular_file(path, ignored) ? fs::file_size(path, ignored) : 0;
  if (!ignored && size > 0) {
    text.resize(size);
    file.read(text.data(), static_cast<std::streamsize>(size));
    text.resize(static_cast<std::size_t>(file.gcount()));
  }
  // The rest by chunks: pipes do not know their size.
  char chunk[1 << 16];
  while (file.read(chunk, sizeof chunk) || file.gcount() > 0)
    text.append(chunk, static_cast<std::size_t>(file.gcount()));
  if (file.bad()) fail("read", path, errno);
  return text;
}

void write_file_atomically(const fs::path& path, std::string_view text) { PendingFile(path, text).commit(); }

void write_files_atomically(std::span<const std::pair<fs::path, std::string>> files) {
  std::deque<PendingFile> pending;
  for (const auto& [path, text] : files) pending.emplace_back(path, text);
  for (PendingFile& file : pending) file.commit();
}

void make_folders(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) fail("make folder", path, error.value());
}

}  // namespace arcway
