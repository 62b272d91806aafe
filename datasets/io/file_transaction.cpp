#include "datasets/io/file_transaction.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <deque>
#include <optional>
#include <random>
#include <stdexcept>
#include <vector>

#include "datasets/io/descriptor.h"

namespace arcway::internal {
namespace {

namespace fs = std::filesystem;
using detail::Descriptor;
using Stopped = std::function<bool()>;

constexpr std::size_t kChunk = std::size_t{1} << 24;  ///< bytes written between two questions whether to stop: 10 ms
constexpr int kMostLinks = 40;                        ///< followed from a path, as the system does

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw FileError("cannot write " + path.string() + ": " + reason);
}
[[noreturn]] void fail(const fs::path& path, int error) { fail(path, std::generic_category().message(error)); }

/// What makes two paths one file: the inode, or the folder's inode and the name of a file that is yet to be made.
struct Identity {
  dev_t device = 0;
  ino_t inode = 0;
  std::string new_name = {};
  bool operator==(const Identity&) const = default;
};

/// A path with its links followed, there or not.
struct Place {
  fs::path folder = {};
  std::string name = {};
  std::optional<int> descriptor = std::nullopt;  ///< descriptor of this process that the path stands for
};

/// N if the path is /proc/self/fd/N, however it is written.
std::optional<int> descriptor_of(const fs::path& path) {
  const std::string name = path.filename().string();
  int number = -1;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (error != std::errc() || end != name.data() + name.size()) return std::nullopt;
  std::error_code ignored;
  const fs::path open_files = fs::canonical("/proc/self/fd", ignored);
  if (ignored || fs::canonical(path.parent_path(), ignored) != open_files || ignored) return std::nullopt;
  return number;
}

Place place_of(const fs::path& given) {
  fs::path path = given;
  std::error_code error;
  for (int links = 0; fs::is_symlink(path, error); ++links) {
    if (const std::optional<int> number = descriptor_of(path)) return {.descriptor = number};
    if (links == kMostLinks) fail(given, ELOOP);
    const fs::path named = fs::read_symlink(path, error);
    if (error) fail(given, error.value());
    path = path.parent_path() / named;
  }
  const fs::path folder = path.parent_path();
  return {.folder = folder.empty() ? "." : folder, .name = path.filename().string()};
}

/// A name beside the target's, whose length has nothing to do with its: names of 255 bytes have no room.
std::string temporary_name() {
  std::random_device random;
  return ".arcway-" + std::to_string(random()) + ".tmp";
}

/// @returns what the system says, or nothing if the file is no mount point, or the system does not say.
bool is_mount_point(int folder, const std::string& name) {
#ifdef STATX_ATTR_MOUNT_ROOT
  struct statx status {};
  return statx(folder, name.c_str(), AT_SYMLINK_NOFOLLOW, STATX_TYPE, &status) == 0 &&
         (status.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
#else
  struct stat in {
  }, file{};
  return ::fstat(folder, &in) == 0 && ::fstatat(folder, name.c_str(), &file, AT_SYMLINK_NOFOLLOW) == 0 &&
         in.st_dev != file.st_dev;
#endif
}

void write_all(int descriptor, std::string_view text, const fs::path& path, const Stopped& stopped) {
  while (true) {
    if (stopped && stopped()) fail(path, EINTR);
    if (text.empty()) return;
    const ssize_t written = ::write(descriptor, text.data(), std::min(text.size(), kChunk));
    if (written < 0 && errno != EINTR) fail(path, errno);
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// Has the system store a file or folder. Some have nothing to store to, which is as good.
void sync(int descriptor, const fs::path& path) {
  if (::fsync(descriptor) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS) fail(path, errno);
}

/// One file of a transaction.
class Output {
 public:
  explicit Output(const fs::path& path) : path_(path), place_(place_of(path)) {
    if (place_.descriptor) {
      check_descriptor();
      return;
    }
    folder_ = Descriptor(::open(place_.folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    if (!folder_.is_open()) fail(path_, errno);
    look_at_target();
    if (is_stream_) return;
    if (is_mount_point(folder_.number(), place_.name))
      fail(path_, "a file system is mounted there, and no new file can take its place; name one in a folder");
    make_temporary();
    remove_temporary();
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output() { remove_temporary(); }

  [[nodiscard]] const fs::path& path() const { return path_; }
  /// None of what is no regular file, which takes what several write.
  [[nodiscard]] const std::optional<Identity>& identity() const { return identity_; }
  [[nodiscard]] bool is_stream() const { return is_stream_ || place_.descriptor; }

  void put(std::string text) { text_ = std::move(text); }
  [[nodiscard]] bool has_text() const { return text_.has_value(); }

  void stage(const Stopped& stopped) {
    Descriptor file = make_temporary();
    struct stat status {};
    if (::fstatat(folder_.number(), place_.name.c_str(), &status, 0) == 0) {
      // Whoever may not give files away keeps the new one as its own.
      [[maybe_unused]] const int owner = ::fchown(file.number(), status.st_uid, status.st_gid);
      [[maybe_unused]] const int mode = ::fchmod(file.number(), status.st_mode & 07777);
    }
    write_all(file.number(), *text_, path_, stopped);
    sync(file.number(), path_);
    if (file.close() != 0) fail(path_, errno);
  }

  void write_stream(const Stopped& stopped) const {
    if (place_.descriptor) return write_all(*place_.descriptor, *text_, path_, stopped);
    const Descriptor file(::openat(folder_.number(), place_.name.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC));
    if (!file.is_open()) fail(path_, errno);
    write_all(file.number(), *text_, path_, stopped);
  }

  /// The new file gets the target's name; the old one keeps another until `forget`.
  void replace() {
    if (is_there_still()) keep_old();
    if (!rename(temporary_, place_.name)) {
      const int error = errno;
      restore();
      fail(path_, error);
    }
    temporary_.clear();
    replaced_ = true;
  }

  /// As it was before `replace`.
  void restore() {
    if (!kept_.empty()) {
      static_cast<void>(rename(kept_, place_.name));
      remove(kept_);  // still there if both were names of one file
    } else if (replaced_) {
      remove(place_.name);
    }
    kept_.clear();
    replaced_ = false;
  }

  void forget() {
    if (!kept_.empty()) remove(kept_);
    kept_.clear();
  }

  void sync_folder() const {
    const Descriptor folder(::openat(folder_.number(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.is_open()) ::fsync(folder.number());  // the files are stored; what their names lead to, as far as it can
  }

  void remove_temporary() {
    if (!temporary_.empty()) remove(temporary_);
    temporary_.clear();
  }

 private:
  void check_descriptor() const {
    const int flags = ::fcntl(*place_.descriptor, F_GETFL);
    if (flags < 0) fail(path_, errno);
    if ((flags & O_ACCMODE) == O_RDONLY) fail(path_, EBADF);
  }

  void look_at_target() {
    struct stat status {};
    const char* name = place_.name.c_str();
    if (place_.name.empty() || place_.name == "." || place_.name == "..") fail(path_, EISDIR);
    if (::fstatat(folder_.number(), name, &status, 0) != 0) {
      if (errno != ENOENT) fail(path_, errno);
      if (::fstat(folder_.number(), &status) != 0) fail(path_, errno);
      identity_ = Identity{status.st_dev, status.st_ino, place_.name};
      return;
    }
    if (S_ISDIR(status.st_mode)) fail(path_, EISDIR);
    if (S_ISSOCK(status.st_mode)) fail(path_, ENXIO);
    if (::faccessat(folder_.number(), name, W_OK, AT_EACCESS) != 0) fail(path_, errno);
    is_stream_ = !S_ISREG(status.st_mode);
    if (!is_stream_) identity_ = Identity{status.st_dev, status.st_ino};
  }

  /// What has come in the target's place meanwhile, if it is no file, is not touched.
  [[nodiscard]] bool is_there_still() const {
    struct stat status {};
    if (::fstatat(folder_.number(), place_.name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) return false;
    if (!S_ISREG(status.st_mode)) fail(path_, S_ISDIR(status.st_mode) ? EISDIR : EEXIST);
    return true;
  }

  void keep_old() {
    std::string kept = temporary_name();
    const int linked = ::linkat(folder_.number(), place_.name.c_str(), folder_.number(), kept.c_str(), 0);
    // A file system without hard links: for a moment there is no file of that name.
    if (linked != 0 && !rename(place_.name, kept)) fail(path_, errno);
    kept_ = std::move(kept);
  }

  Descriptor make_temporary() {
    constexpr mode_t kAllButExecute = 0666;  // less what the process's mask says
    temporary_ = temporary_name();
    Descriptor file(
        ::openat(folder_.number(), temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kAllButExecute));
    if (file.is_open()) return file;
    const int error = errno;
    temporary_.clear();
    fail(path_, error);
  }

  [[nodiscard]] bool rename(const std::string& from, const std::string& to) const {
    return ::renameat(folder_.number(), from.c_str(), folder_.number(), to.c_str()) == 0;
  }
  void remove(const std::string& name) const { ::unlinkat(folder_.number(), name.c_str(), 0); }

  fs::path path_;
  Place place_;
  Descriptor folder_;
  bool is_stream_ = false;
  std::optional<Identity> identity_;
  std::optional<std::string> text_;
  std::string temporary_, kept_;  ///< names in the folder of files that the transaction has made
  bool replaced_ = false;
};

struct Protected {
  fs::path path;
  Identity identity;
  std::string why;
};

}  // namespace

struct FileTransaction::Data {
  std::deque<Output> outputs;
  std::vector<Protected> kept;

  static void refuse_same(const Output& output, const Protected& kept) {
    if (output.identity() != kept.identity) return;
    const std::string same = output.path() == kept.path ? "" : "is " + kept.path.string() + ", which ";
    fail(output.path(), same + kept.why + ", and would be replaced by what is written");
  }

  void stage(const Stopped& stopped) {
    for (Output& output : outputs)
      if (output.has_text() && !output.is_stream()) output.stage(stopped);
    for (const Output& output : outputs)
      if (output.has_text() && output.is_stream()) output.write_stream(stopped);
  }

  void replace() {
    std::vector<Output*> replaced;
    try {
      for (Output& output : outputs) {
        if (!output.has_text() || output.is_stream()) continue;
        output.replace();
        replaced.push_back(&output);
      }
    } catch (const FileError&) {
      std::for_each(replaced.rbegin(), replaced.rend(), [](Output* output) { output->restore(); });
      throw;
    }
    for (Output* output : replaced) output->forget();
    for (const Output* output : replaced) output->sync_folder();
  }
};

FileTransaction::FileTransaction() : data_(std::make_unique<Data>()) {}
FileTransaction::~FileTransaction() = default;

void FileTransaction::protect(const fs::path& path, std::string_view why) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return;
  data_->kept.push_back({path, {status.st_dev, status.st_ino}, std::string(why)});
  for (const Output& output : data_->outputs) Data::refuse_same(output, data_->kept.back());
}

void FileTransaction::claim(const fs::path& target) {
  Output& output = data_->outputs.emplace_back(target);
  for (const Protected& kept : data_->kept) Data::refuse_same(output, kept);
  for (const Output& other : data_->outputs) {
    if (&other == &output || !output.identity() || other.identity() != output.identity()) continue;
    const std::string names = other.path() == target ? "" : "is " + other.path().string() + ": ";
    fail(target, names + "two files of this name are to be written");
  }
}

void FileTransaction::put(const fs::path& target, std::string text) {
  const auto output =
      std::ranges::find_if(data_->outputs, [&](const Output& o) { return o.path() == target && !o.has_text(); });
  if (output == data_->outputs.end()) throw std::logic_error("not claimed: " + target.string());
  output->put(std::move(text));
}

void FileTransaction::commit(const std::function<bool()>& stopped) {
  try {
    data_->stage(stopped);
    data_->replace();
  } catch (...) {
    for (Output& output : data_->outputs) output.remove_temporary();
    throw;
  }
  data_->outputs.clear();
}

}  // namespace arcway::internal
