#pragma once

#include <string>

#include "arcway/datasets/file_io.h"

namespace arcway::internal::test {

/// The message of the FormatError that the action ends with, or "no error". Other exceptions pass.
template <class Action>
std::string format_error_of(Action action) {
  try {
    action();
  } catch (const FormatError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace arcway::internal::test
