#include <algorithm>
#include <charconv>
#include <string>

#include "arcway/datasets/file_io.h"
#include "datasets/formats/gray_image.h"
#include "datasets/formats/text_scanner.h"

namespace arcway::internal {
namespace {

class PgmReader {
 public:
  PgmReader(std::string_view bytes, std::string_view name) : bytes_(bytes), name_(name) {}

  GrayImage read(std::size_t max_pixels) {
    if (!bytes_.starts_with("P2") && !bytes_.starts_with("P5")) fail("expected PGM, which begins with P2 or P5");
    const bool binary = bytes_[1] == '5';
    at_ = 2;
    GrayImage image;
    image.width = number("the width", 1, SIZE_MAX);
    image.height = number("the height", 1, SIZE_MAX);
    image.max_value = static_cast<std::uint32_t>(number("the largest value", 1, 65535));
    if (image.width > max_pixels / image.height)
      fail(std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels; at most " +
           std::to_string(max_pixels) + " are read");
    const std::size_t pixels = image.width * image.height;
    binary ? read_bytes(image, pixels) : read_text(image, pixels);
    return image;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw FormatError(std::string(name_) + ": byte " + std::to_string(at_) + ": " + message);
  }

  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  void skip_space_and_comments() {
    while (at_ < bytes_.size() && (is_space(bytes_[at_]) || bytes_[at_] == '#')) {
      if (bytes_[at_] == '#') {
        at_ = std::min(bytes_.find('\n', at_), bytes_.size());
      } else {
        ++at_;
      }
    }
  }

  [[nodiscard]] std::string found() const {
    const auto end = std::find_if(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), bytes_.end(), is_space);
    return at_ == bytes_.size()
               ? "the end of the file"
               : detail::quoted(bytes_.substr(at_, static_cast<std::size_t>(end - bytes_.begin()) - at_));
  }

  std::size_t number(const char* what, std::size_t least, std::size_t most) {
    skip_space_and_comments();
    std::size_t value = 0;
    const char* begin = bytes_.data() + at_;
    const auto [end, error] = std::from_chars(begin, bytes_.data() + bytes_.size(), value);
    if (error != std::errc() || value < least || value > most)
      fail(std::string("expected ") + what + " as a whole number from " + std::to_string(least) +
           (most < SIZE_MAX ? " to " + std::to_string(most) : "") + ", found " + found());
    at_ += static_cast<std::size_t>(end - begin);
    return value;
  }

  void read_bytes(GrayImage& image, std::size_t pixels) {
    if (at_ == bytes_.size() || !is_space(bytes_[at_])) fail("expected one blank before the pixels");
    ++at_;
    const std::size_t size = image.max_value < 256 ? 1 : 2;
    if (bytes_.size() - at_ < pixels * size)
      fail("expected " + std::to_string(pixels * size) + " bytes of pixels, found " +
           std::to_string(bytes_.size() - at_));
    image.samples.reserve(pixels);
    for (std::size_t i = 0; i < pixels; ++i, at_ += size) {
      const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(bytes_[at_ + k]); };
      add(image, size == 1 ? byte(0) : (std::uint32_t{byte(0)} << 8) | byte(1));
    }
  }

  void read_text(GrayImage& image, std::size_t pixels) {
    // A pixel takes a digit and a blank: the text, not the header, says how much memory it takes.
    image.samples.reserve(std::min(pixels, bytes_.size() / 2 + 1));
    for (std::size_t i = 0; i < pixels; ++i)
      add(image, static_cast<std::uint32_t>(number("a pixel", 0, image.max_value)));
  }

  void add(GrayImage& image, std::uint32_t value) {
    if (value > image.max_value)
      fail("pixel is " + std::to_string(value) + ", the largest value is " + std::to_string(image.max_value));
    image.samples.push_back(static_cast<std::uint16_t>(value));
  }

  std::string_view bytes_;
  std::string_view name_;
  std::size_t at_ = 0;
};

}  // namespace

GrayImage read_pgm(std::string_view bytes, std::string_view name, std::size_t max_pixels) {
  return PgmReader(bytes, name).read(max_pixels);
}

}  // namespace arcway::internal
