#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "datasets/io/file_transaction.h"

namespace arcway::internal::cli {

/// Files that a command writes: all of them whole, or none, whatever ends the tool meanwhile. Made before anything
/// takes long, as it finds out what cannot be written.
class OutputFiles {
 public:
  /// @param targets  of options; empty ones are not asked for.
  /// @param inputs   files that are read and not to be replaced; names of no file, as of the catalog, do not count.
  /// @param writes   false in all but one of several processes that do the same: they leave the files alone.
  /// @throws FileError naming the target that cannot be written, is read, or is named twice.
  explicit OutputFiles(const std::vector<std::string>& targets, const std::vector<std::string>& inputs = {},
                       bool writes = true);

  /// Files that turn out to be read.
  void protect(const std::vector<std::filesystem::path>& inputs);
  /// One of the targets, which stays as it is if nothing is added.
  void add(const std::string& target, std::string text);
  void write();
  /// One line a file.
  [[nodiscard]] std::string summary() const;

 private:
  bool writes_;
  FileTransaction files_;
  std::vector<std::string> added_;
};

}  // namespace arcway::internal::cli
