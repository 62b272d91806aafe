#pragma once

#include <filesystem>
#include <string>

namespace arcway::internal {

/// The contents of a file, expanded if gzip compressed it.
/// @throws FileError if it cannot be read, FormatError if it is compressed and damaged.
std::string read_expanded(const std::filesystem::path& path);

/// A file that another one names: by its path from there, or beside it, as it is or compressed.
/// @throws FileError naming both if there is none.
std::filesystem::path find_beside(const std::filesystem::path& path, const std::string& named);

}  // namespace arcway::internal
