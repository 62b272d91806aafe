#include "datasets/io/gzip.h"

#include <zlib.h>

#include <limits>

#include "arcway/datasets/file_io.h"

namespace arcway::internal {
namespace {

struct Inflater {
  z_stream stream{};
  bool ready = inflateInit2(&stream, 16 + MAX_WBITS) == Z_OK;  // 16: a gzip header
  Inflater() = default;
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&stream); }
};

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1F\x8B"); }

std::string expand_gzip(std::string_view bytes, std::string_view name, std::size_t max_bytes) {
  const auto fail = [&](const std::string& message) { throw FormatError(std::string(name) + ": gzip: " + message); };
  if (bytes.size() > std::numeric_limits<uInt>::max()) fail("more than 4 GiB");
  Inflater inflater;
  if (!inflater.ready) fail("out of memory");
  z_stream& stream = inflater.stream;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // zlib does not write to it
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string text;
  while (true) {
    char chunk[1 << 16];
    stream.next_out = reinterpret_cast<Bytef*>(chunk);
    stream.avail_out = sizeof chunk;
    const int result = inflate(&stream, Z_NO_FLUSH);
    text.append(chunk, sizeof chunk - stream.avail_out);
    if (text.size() > max_bytes) fail("more than " + std::to_string(max_bytes) + " bytes of text");
    if (result == Z_STREAM_END) {
      const std::string_view rest = bytes.substr(bytes.size() - stream.avail_in);
      if (rest.find_first_not_of('\0') == std::string_view::npos) return text;  // blocks of tapes are filled with zeros
      if (!is_gzip(rest))
        fail("byte " + std::to_string(bytes.size() - rest.size()) + ": neither another member nor zeros");
      if (inflateReset(&stream) != Z_OK) fail("damaged");
      continue;
    }
    if (result == Z_BUF_ERROR || (result == Z_OK && stream.avail_in == 0 && stream.avail_out > 0))
      fail("the file ends too early");
    if (result != Z_OK) fail(stream.msg != nullptr ? stream.msg : "damaged");
  }
}

}  // namespace arcway::internal
