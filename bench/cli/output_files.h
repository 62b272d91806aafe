#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "datasets/io/file_transaction.h"

namespace arcway::internal::cli {

/// The output files of a command: all are written completely, or none, whatever ends the tool meanwhile. Construct it
/// before long work, because it finds out what cannot be written.
class OutputFiles {
 public:
  /// @param targets  output options; empty ones are ignored, and "-" is standard output.
  /// @param inputs   files that are read and must not be replaced; names of no file, as of the catalog, are ignored.
  /// @param writes   false in all but one of several processes that run the same command: they leave the files alone.
  /// @throws FileError naming the target that cannot be written, is read, or is named twice.
  explicit OutputFiles(const std::vector<std::string>& targets, const std::vector<std::string>& inputs = {},
                       bool writes = true);

  /// Adds files that turn out to be inputs.
  void protect(const std::vector<std::filesystem::path>& inputs);
  /// Sets the content of a target. A target without content stays as it is.
  void add(const std::string& target, std::string text);
  void write();
  /// Text with one line a file.
  [[nodiscard]] std::string summary() const;

 private:
  bool writes_;
  FileTransaction files_;
  std::vector<std::string> added_;
};

}  // namespace arcway::internal::cli
