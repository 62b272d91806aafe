#include "datasets/formats/gray_image.h"

#include <string>

#include "arcway/datasets/detect_format.h"
#include "arcway/datasets/file_io.h"

namespace arcway::internal {

GrayImage read_gray_image(std::string_view bytes, std::string_view name, std::size_t max_pixels) {
  switch (detect_format(bytes, name)) {
    case MapFormat::kPgm:
      return read_pgm(bytes, name, max_pixels);
    case MapFormat::kPng:
      return read_png(bytes, name, max_pixels);
    default:
      throw FormatError(std::string(name) + ": expected a PGM or PNG image");
  }
}

}  // namespace arcway::internal
