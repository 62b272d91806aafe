#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "datasets/io/shortened.h"

namespace arcway::internal::report {

/// What went wrong, without the name of the exception in brackets that the library begins with.
inline std::string message_of(const nlohmann::json::exception& error) {
  const std::string message = error.what();
  const std::size_t end = message.find("] ");
  return shortened(end == std::string::npos ? message : message.substr(end + 2), kMostOfParser);
}

}  // namespace arcway::internal::report
