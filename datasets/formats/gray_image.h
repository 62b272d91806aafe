#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace arcway::internal {

/// An image in shades of gray, row 0 at the top.
struct GrayImage {
  std::size_t width = 0, height = 0;
  std::uint32_t max_value = 255;       ///< white
  std::vector<std::uint16_t> samples;  ///< width * height, 0 (black) to max_value
  std::vector<bool> transparent;       ///< not fully opaque; empty if all are
};

/// Reads Netpbm's PGM, text (P2) or binary (P5), 8 or 16 bits; of several images the first.
/// @param max_pixels  more than these are refused.
/// @throws FormatError, "a.pgm: expected 1000 bytes of pixels, found 17".
GrayImage read_pgm(std::string_view bytes, std::string_view name, std::size_t max_pixels);

/// Reads PNG; colors become gray, 16 bits stay.
/// @throws FormatError with what libpng says.
GrayImage read_png(std::string_view bytes, std::string_view name, std::size_t max_pixels);

/// Reads either of them, told by the content.
/// @throws FormatError also if it is neither.
GrayImage read_gray_image(std::string_view bytes, std::string_view name, std::size_t max_pixels);

}  // namespace arcway::internal
