#pragma once

#include <string>

namespace arcway::internal::cli {

/// A regular file in memory with all that standard input has, until the tool ends. Formats are told by their first
/// bytes, and read again from the start: a pipe would be at its end.
/// @throws FileError
std::string copy_of_standard_input();

/// The message with names of such files replaced by "standard input".
std::string with_stream_names(std::string text);

/// Whether an output is "-". What is printed then goes to standard error, so that it does not mix with the data.
bool writes_data_to_standard_output();
void set_writes_data_to_standard_output();

/// Whether --quiet was given: nothing is printed but errors and what "-" asks for.
bool is_quiet();
void set_quiet();

}  // namespace arcway::internal::cli
