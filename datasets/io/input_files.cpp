#include "datasets/io/input_files.h"

#include <algorithm>
#include <system_error>

#include "arcway/datasets/file_io.h"
#include "datasets/io/gzip.h"
#include "datasets/io/shortened.h"

namespace arcway::internal {

namespace fs = std::filesystem;

std::string read_expanded(const fs::path& path) {
  std::string bytes = read_file(path);
  return is_gzip(bytes) ? expand_gzip(bytes, path.string()) : bytes;
}

fs::path find_beside(const fs::path& path, const std::string& named) {
  const fs::path folder = path.parent_path();
  std::string slashed = named;
  std::ranges::replace(slashed, '\\', '/');  // as written on Windows
  for (const fs::path& candidate : {folder / named, folder / slashed, folder / fs::path(slashed).filename()}) {
    for (const char* ending : {"", ".gz"}) {
      fs::path file = candidate;
      file += ending;
      std::error_code error;
      const fs::file_status status = fs::status(file, error);
      if (fs::is_fifo(status))  // nobody may ever write to it
        throw FileError(path.string() + " needs another file: " + shortened(file.string(), kMostOfParser) +
                        " is a pipe; write what comes out of it to a file");
      if (fs::exists(status) && !fs::is_directory(status)) return file;
    }
  }
  throw FileError(path.string() + " needs another file: cannot read " +
                  shortened((folder / named).string(), kMostOfParser) + ": No such file or directory, nor is " +
                  shortened(fs::path(slashed).filename().string()) + " beside it");
}

}  // namespace arcway::internal
