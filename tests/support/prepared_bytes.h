#pragma once

#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace arcway::internal::test {

// The layout that datasets/README.md describes, read independently of the library.

template <class T>
T number_at(const std::string& bytes, std::size_t place) {
  T value{};
  if (place + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

struct PreparedSection {
  std::uint64_t offset = 0, count = 0;
  std::uint32_t element_bytes = 0;
};

inline PreparedSection section_of(const std::string& bytes, std::uint32_t id) {
  for (std::size_t entry = 40; entry < 40 + 32 * number_at<std::uint32_t>(bytes, 20); entry += 32)
    if (number_at<std::uint32_t>(bytes, entry) == id)
      return {number_at<std::uint64_t>(bytes, entry + 8), number_at<std::uint64_t>(bytes, entry + 16),
              number_at<std::uint32_t>(bytes, entry + 24)};
  return {};
}

/// Makes the checksums of a prepared map right again wherever sections lie within the file, as well as its size.
inline void mend_checksums(std::string& bytes) {
  if (bytes.size() < 40) return;
  const auto crc = [&](std::size_t begin, std::size_t size) {
    return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()) + begin, size));
  };
  const auto put = [&](std::size_t place, const auto& value) { std::memcpy(&bytes[place], &value, sizeof value); };
  const std::size_t sections = number_at<std::uint32_t>(bytes, 20);
  if (sections <= (bytes.size() - 40) / 32) {
    for (std::size_t entry = 40; entry < 40 + 32 * sections; entry += 32) {
      const auto offset = number_at<std::uint64_t>(bytes, entry + 8),
                 count = number_at<std::uint64_t>(bytes, entry + 16);
      const auto each = number_at<std::uint32_t>(bytes, entry + 24);
      if (each == 0 || offset > bytes.size() || count > (bytes.size() - offset) / each) continue;
      put(entry + 4, crc(offset, count * each));
    }
    put(32, crc(40, 32 * sections));
  }
  put(24, static_cast<std::uint64_t>(bytes.size()));
  put(36, crc(0, 36));
}

}  // namespace arcway::internal::test
