#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "arcway/export.h"

namespace arcway {

/// A file that cannot be read or written. The message names the path and the system's reason.
class ARCWAY_API FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that cannot be read as what it should be. The message names file, place and value.
class ARCWAY_API FormatError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What `read_file` takes at most [bytes]; ten million vertices of GeoJSON have a tenth of it.
inline constexpr std::size_t kMostFileBytes = std::size_t{1} << 32;

/// The whole file. Memory follows its size.
/// @param max_bytes  more are refused, before they are read where the file says its size. Of devices, which may never
///   end, 16 MiB are read at most.
/// @throws FileError
ARCWAY_API std::string read_file(const std::filesystem::path& path, std::size_t max_bytes = kMostFileBytes);

/// Writes to a temporary file beside `path` and renames it: readers see the old file or the new one, never half of
/// it, and a failure leaves the old one. See FileTransaction for several files.
/// @throws FileError
ARCWAY_API void write_file_atomically(const std::filesystem::path& path, std::string_view text);

/// Makes a folder and all folders that it lies in.
/// @throws FileError
ARCWAY_API void make_folders(const std::filesystem::path& path);

}  // namespace arcway
