#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "arcway/datasets/file_io.h"

namespace arcway::internal {

/// Files that replace the ones of their names together: all of them, or none.
///
///     FileTransaction files;
///     files.protect("map.yaml");
///     files.claim("plan.json");     // before anything takes long
///     files.put("plan.json", text);
///     files.commit();
///
/// Files are the same if they have the same device and inode, or will have the same name in the same folder, whatever
/// their paths say. Symbolic links stay, and what they lead to is replaced. Devices, pipes and open descriptors
/// (/dev/stdout) are written as they are, by several outputs if need be. Not thread-safe.
class FileTransaction {
 public:
  FileTransaction();
  FileTransaction(const FileTransaction&) = delete;
  FileTransaction& operator=(const FileTransaction&) = delete;
  ~FileTransaction();

  /// A file that must stay as it is. Names of no regular file do not count.
  /// @param why  "was read": for the message.
  /// @throws FileError if it is claimed.
  void protect(const std::filesystem::path& path, std::string_view why = "was read");

  /// A file to write. Makes and removes an empty file beside it to see that one can be made.
  /// @throws FileError if it cannot be written or replaced (a folder, a mount point, no permission), is protected, or
  ///   is claimed already.
  void claim(const std::filesystem::path& target);

  /// What a claimed file is to hold. Claimed files that nothing is put in stay as they are.
  /// @throws std::logic_error if it is not claimed.
  void put(const std::filesystem::path& target, std::string text);

  /// Writes everything to new files beside the old ones, has the system store them, writes devices and pipes, and then
  /// renames the new files. A failure removes the new files, and gives those that were replaced their names back.
  /// @param stopped  asked while files are written: true ends the commit as a failure. Not asked while files are
  ///   renamed.
  /// @throws FileError
  void commit(const std::function<bool()>& stopped = {});

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace arcway::internal
