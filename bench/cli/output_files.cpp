#include "bench/cli/output_files.h"

#include <utility>

#include "bench/cli/arguments.h"
#include "bench/cli/deferred_signals.h"
#include "bench/cli/standard_streams.h"

namespace arcway::internal::cli {
namespace {

// "-" is standard output.
std::string output_path(const std::string& target) { return target == "-" ? "/dev/stdout" : target; }

bool is_standard_output(const std::string& target) {
  return target == "-" || target == "/dev/stdout" || target == "/dev/fd/1" || target == "/proc/self/fd/1";
}

// Two files in one stream, as one of JSON and one of CSV, are of use to nobody.
void check_standard_output(const std::vector<std::string>& targets) {
  std::string first;
  for (const std::string& target : targets) {
    if (!is_standard_output(target)) continue;
    if (!first.empty())
      throw FileError("cannot write " + target + ": " + (first == target ? "" : "is " + first + ": ") +
                      "two files are to be written to standard output");
    first = target;
  }
}

}  // namespace

OutputFiles::OutputFiles(const std::vector<std::string>& targets, const std::vector<std::string>& inputs, bool writes)
    : writes_(writes) {
  if (!writes_) return;
  check_standard_output(targets);
  for (const std::string& input : inputs)
    if (!input.empty() && input != "-") files_.protect(input);
  files_.protect("/dev/stdout", "takes what is printed");
  const DeferredSignals signals;  // none leaves the file behind by which the target is tried
  for (const std::string& target : targets) {
    if (target == "-") set_writes_data_to_standard_output();
    if (!target.empty()) files_.claim(output_path(target));
  }
}

void OutputFiles::protect(const std::vector<std::filesystem::path>& inputs) {
  for (const std::filesystem::path& input : inputs) files_.protect(input);
}

void OutputFiles::add(const std::string& target, std::string text) {
  if (target.empty()) return;
  if (writes_) files_.put(output_path(target), std::move(text));
  added_.push_back(target);
}

void OutputFiles::write() {
  const DeferredSignals signals;
  files_.commit(DeferredSignals::arrived);
}

std::string OutputFiles::summary() const {
  std::string text;
  for (const std::string& file : added_) text += row("wrote", file == "-" ? "standard output" : file);
  return text;
}

}  // namespace arcway::internal::cli
