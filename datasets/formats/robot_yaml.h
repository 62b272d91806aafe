#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace arcway::internal {

/// A robot in YAML as the JSON object of its keys, for `read_robot`. The document may have these keys at its top, or be
/// the parameters of nav2: there "footprint" and "minimum_turning_radius" are taken from wherever they stand below a
/// "ros__parameters", and nothing else is. Where they stand twice with different values, that is an error.
/// @throws FormatError naming line or key.
nlohmann::json robot_of_yaml(std::string_view yaml, std::string_view name);

}  // namespace arcway::internal
