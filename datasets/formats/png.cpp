#include <png.h>

#include <csetjmp>
#include <cstring>
#include <string>

#include "arcway/datasets/file_io.h"
#include "datasets/formats/gray_image.h"

namespace arcway::internal {
namespace {

// libpng reports errors by longjmp, which must not pass over destructors: what is allocated lives in Decoder, outside
// of the functions that it leaves.
class Decoder {
 public:
  Decoder(std::string_view bytes, std::size_t max_pixels) : bytes_(bytes), max_pixels_(max_pixels) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
  }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  ~Decoder() { png_destroy_read_struct(&png_, &info_, nullptr); }

  // False with a message on failure.
  bool decode() {
    if (info_ == nullptr || !read_header()) return false;
    rows_.resize(row_bytes_ * height_);
    for (std::size_t y = 0; y < height_; ++y) row_pointers_.push_back(rows_.data() + y * row_bytes_);
    return read_pixels();
  }

  [[nodiscard]] std::string message() const { return message_; }

  [[nodiscard]] GrayImage image() const {
    const std::size_t sample_bytes = depth_ / 8;
    const auto sample = [&](const png_byte* at) {
      return static_cast<std::uint16_t>(sample_bytes == 1 ? at[0] : (at[0] << 8) | at[1]);
    };
    GrayImage image;
    image.width = width_;
    image.height = height_;
    image.max_value = depth_ == 8 ? 255 : 65535;
    image.samples.reserve(width_ * height_);
    for (std::size_t i = 0; i < width_ * height_; ++i) {
      const png_byte* pixel = rows_.data() + i * channels_ * sample_bytes;
      image.samples.push_back(sample(pixel));
      if (channels_ == 2) image.transparent.push_back(sample(pixel + sample_bytes) < image.max_value);
    }
    return image;
  }

 private:
  [[noreturn]] static void on_error(png_structp png, png_const_charp message) {
    auto* self = static_cast<Decoder*>(png_get_error_ptr(png));
    std::strncpy(self->message_, message, sizeof self->message_ - 1);
    png_longjmp(png, 1);
  }
  static void on_warning(png_structp, png_const_charp) {}
  static void on_read(png_structp png, png_bytep out, std::size_t count) {
    auto* self = static_cast<Decoder*>(png_get_io_ptr(png));
    if (count > self->bytes_.size()) png_error(png, "the file ends too early");
    std::memcpy(out, self->bytes_.data(), count);
    self->bytes_.remove_prefix(count);
  }

  bool read_header() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_read_fn(png_, this, on_read);
    png_set_user_limits(png_, 0x7FFFFFFF, 0x7FFFFFFF);
    png_read_info(png_, info_);
    width_ = png_get_image_width(png_, info_);
    height_ = png_get_image_height(png_, info_);
    if (width_ > max_pixels_ / height_) png_error(png_, "more pixels than are read");
    png_set_expand(png_);
    png_set_rgb_to_gray(png_, PNG_ERROR_ACTION_NONE, PNG_RGB_TO_GRAY_DEFAULT, PNG_RGB_TO_GRAY_DEFAULT);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    row_bytes_ = png_get_rowbytes(png_, info_);
    channels_ = png_get_channels(png_, info_);
    depth_ = png_get_bit_depth(png_, info_);
    if (channels_ > 2 || (depth_ != 8 && depth_ != 16)) png_error(png_, "unexpected kind of pixels");
    return true;
  }
  bool read_pixels() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_image(png_, row_pointers_.data());
    png_read_end(png_, nullptr);
    return true;
  }

  std::string_view bytes_;
  std::size_t max_pixels_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::size_t width_ = 0, height_ = 0, row_bytes_ = 0, channels_ = 0, depth_ = 0;
  std::vector<png_byte> rows_;
  std::vector<png_bytep> row_pointers_;
  char message_[128] = "out of memory";  // unless libpng says otherwise
};

}  // namespace

GrayImage read_png(std::string_view bytes, std::string_view name, std::size_t max_pixels) {
  Decoder decoder(bytes, max_pixels);
  if (!decoder.decode()) throw FormatError(std::string(name) + ": PNG: " + decoder.message());
  return decoder.image();
}

}  // namespace arcway::internal
