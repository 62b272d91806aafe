#pragma once

#include <concepts>
#include <ostream>
#include <string>
#include <type_traits>

namespace arcway {

/// A type that has a text: a function `to_string(value)` in its own namespace gives it. Poses, paths, worlds, vehicles,
/// requests, statuses, results, trajectories and reports have one, declared beside the type.
template <class T>
concept HasText = (std::is_class_v<T> || std::is_enum_v<T>)&&requires(const T& value) {
  { to_string(value) } -> std::same_as<std::string>;
};

/// Writes to_string(value), on one line and for people. Numbers of poses read back to the same doubles, others are
/// rounded: formats for programs are in datasets.
template <HasText T>
std::ostream& operator<<(std::ostream& out, const T& value) {
  return out << to_string(value);
}

}  // namespace arcway
