#include "bench/cli/standard_streams.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <system_error>

#include "arcway/datasets/file_io.h"

namespace arcway::internal::cli {
namespace {

constexpr std::string_view kDescriptors = "/proc/self/fd/";

std::string copy_name;  // name of the copy of standard input; empty: none
bool data_is_printed = false, quiet_is_asked = false;

[[noreturn]] void refuse_input(const char* action) {
  throw FileError(std::string("cannot ") + action + " standard input: " + std::generic_category().message(errno));
}

}  // namespace

std::string copy_of_standard_input() {
  const std::string text = read_file("/dev/stdin");
  const int file = ::memfd_create("standard input", MFD_CLOEXEC);
  if (file < 0) refuse_input("copy");
  std::string_view rest = text;
  while (!rest.empty()) {
    const ssize_t written = ::write(file, rest.data(), rest.size());
    if (written < 0 && errno != EINTR) refuse_input("copy");
    if (written > 0) rest.remove_prefix(static_cast<std::size_t>(written));
  }
  copy_name = std::string(kDescriptors) + std::to_string(file);
  return copy_name;
}

std::string with_stream_names(std::string text) {
  for (std::size_t at = copy_name.empty() ? std::string::npos : text.find(copy_name); at != std::string::npos;
       at = text.find(copy_name, at))
    text.replace(at, copy_name.size(), "standard input");
  return text;
}

bool writes_data_to_standard_output() { return data_is_printed; }
void set_writes_data_to_standard_output() { data_is_printed = true; }
bool is_quiet() { return quiet_is_asked; }
void set_quiet() { quiet_is_asked = true; }

}  // namespace arcway::internal::cli
