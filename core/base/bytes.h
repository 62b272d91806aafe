#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace arcway::internal {

/// Appends values as their bytes in memory, for processes on machines of one type.
template <class T>
requires std::is_trivially_copyable_v<T>
void append_bytes(std::string& bytes, std::span<const T> values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}
template <class T>
requires std::is_trivially_copyable_v<T>
void append_bytes(std::string& bytes, const T& value) { append_bytes(bytes, std::span<const T>(&value, 1)); }

/// Checks that `bytes` holds at least `count` values.
/// @throws std::length_error
template <class T>
void require_bytes(std::string_view bytes, std::size_t count) {
  if (bytes.size() / sizeof(T) < count)
    throw std::length_error(std::to_string(bytes.size()) + " bytes left for " + std::to_string(count) + " values of " +
                            std::to_string(sizeof(T)) + " bytes");
}
/// Takes the first `count` values, or one value, off the front of `bytes`.
/// @throws std::length_error if it holds fewer.
template <class T>
std::vector<T> take_bytes(std::string_view& bytes, std::size_t count) {
  require_bytes<T>(bytes, count);
  std::vector<T> values(count);
  if (count > 0) std::memcpy(values.data(), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
  return values;
}
template <class T>
T take_bytes(std::string_view& bytes) {
  require_bytes<T>(bytes, 1);
  T value{};
  std::memcpy(&value, bytes.data(), sizeof(T));
  bytes.remove_prefix(sizeof(T));
  return value;
}

}  // namespace arcway::internal
