#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace [[gnu::visibility("default")]] arcway {

/// A file that cannot be read or written. The message names the path and the system's reason.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that cannot be read as what it should be. The message names file, place and value.
class FormatError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The whole file.
/// @throws FileError
std::string read_file(const std::filesystem::path& path);

/// Writes to a temporary file beside `path` and renames it: readers see the old file or the new one, never half of
/// it, and a failure leaves the old one.
/// @throws FileError
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

/// The same for several: none takes its place before all are written.
/// @throws FileError
void write_files_atomically(std::span<const std::pair<std::filesystem::path, std::string>> files);

/// With all folders that it lies in, where they are not there yet.
/// @throws FileError
void make_folders(const std::filesystem::path& path);

}  // namespace arcway
