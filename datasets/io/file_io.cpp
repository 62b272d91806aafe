#include "arcway/datasets/file_io.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "datasets/io/descriptor.h"
#include "datasets/io/file_transaction.h"

namespace arcway {

using namespace internal;
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const char* action, const fs::path& path, const std::string& reason) {
  throw FileError(std::string("cannot ") + action + " " + path.string() + ": " + reason);
}
[[noreturn]] void fail(const char* action, const fs::path& path, int error) {
  fail(action, path, std::generic_category().message(error));
}

/// Devices may never end: /dev/zero. Of a terminal nobody reaches this.
constexpr std::size_t kMostOfDevice = std::size_t{1} << 24;

}  // namespace

std::string read_file(const fs::path& path, std::size_t max_bytes) {
  constexpr std::size_t kChunk = 1 << 16;
  const detail::Descriptor file(::open(path.c_str(), O_RDONLY | O_NOCTTY | O_CLOEXEC));
  struct stat status {};
  if (!file.is_open() || ::fstat(file.number(), &status) != 0) fail("read", path, errno);
  if (S_ISDIR(status.st_mode)) fail("read", path, EISDIR);
  const bool is_device = S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode);
  const std::size_t most = is_device ? std::min(kMostOfDevice, max_bytes) : max_bytes;
  const auto refuse = [&](const std::string& size) {
    fail("read", path,
         (is_device ? "a device of " : "") + size + " bytes, at most " + std::to_string(most) + " are read");
  };
  const std::size_t said = S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 0;
  if (said > most) refuse(std::to_string(said));

  std::string text(said > 0 ? said + 1 : kChunk, '\0');  // with a byte more than the file says, that shows its end
  std::size_t size = 0;
  while (true) {
    if (size == text.size()) text.resize(2 * size);
    const ssize_t read = ::read(file.number(), text.data() + size, text.size() - size);
    if (read == 0) break;
    if (read < 0 && errno != EINTR) fail("read", path, errno);
    if (read > 0) size += static_cast<std::size_t>(read);
    if (size > most) refuse("more than " + std::to_string(most));
  }
  text.resize(size);
  return text;
}

void make_folders(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) fail("make folder", path, error.value());
}

void write_file_atomically(const fs::path& path, std::string_view text) {
  FileTransaction file;
  file.claim(path);
  file.put(path, std::string(text));
  file.commit();
}

}  // namespace arcway
