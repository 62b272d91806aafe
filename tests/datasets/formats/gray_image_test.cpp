#include "datasets/formats/gray_image.h"

#include <gtest/gtest.h>

#include "arcway/datasets/file_io.h"
#include "tests/support/format_errors.h"

namespace arcway::internal {
namespace {

constexpr std::size_t kMany = 1000;

std::string pgm_error(const std::string& bytes) {
  return test::format_error_of([&] { read_pgm(bytes, "a.pgm", kMany); });
}
std::string sample(const std::string& name) {
  return read_file(std::string(ARCWAY_SOURCE_DIR) + "/tests/data/" + name);
}

TEST(Pgm, ReadsTextWithComments) {
  const GrayImage image =
      read_pgm("P2 # made by hand\n# size\n3\t2\r\n# white\n100\n0 50 100\n 7\n8 9 and more", "a", kMany);
  EXPECT_EQ(image.width, 3u);
  EXPECT_EQ(image.height, 2u);
  EXPECT_EQ(image.max_value, 100u);
  EXPECT_EQ(image.samples, (std::vector<std::uint16_t>{0, 50, 100, 7, 8, 9}));
}

TEST(Pgm, ReadsBytesOfOneAndTwo) {
  // One white-space byte after the largest value, even if the pixels look like white space.
  const GrayImage small = read_pgm(std::string("P5\n2 2\n255\n\n\x80\xFF ", 16), "a", kMany);
  EXPECT_EQ(small.samples, (std::vector<std::uint16_t>{10, 128, 255, 32}));
  const GrayImage large = read_pgm(std::string("P5 2 1 1000 \x03\xE8\x00\x01second image", 28), "a", kMany);
  EXPECT_EQ(large.samples, (std::vector<std::uint16_t>{1000, 1}));
  // From 256 on.
  EXPECT_EQ(read_pgm(std::string("P5 1 1 256 \1\0", 13), "a", kMany).samples, (std::vector<std::uint16_t>{256}));
  EXPECT_EQ(large.max_value, 1000u);
}

TEST(Pgm, ErrorsNameTheByte) {
  EXPECT_EQ(pgm_error("P3 1 1 1 0"), "a.pgm: byte 0: expected PGM, which begins with P2 or P5");
  EXPECT_EQ(pgm_error("P2 0 1 1 0"), "a.pgm: byte 3: expected the width as a whole number from 1, found \"0\"");
  EXPECT_EQ(pgm_error("P2 1 1 70000 0"),
            "a.pgm: byte 7: expected the largest value as a whole number from 1 to 65535, found \"70000\"");
  EXPECT_EQ(pgm_error("P2 2 1 9 10 0"), "a.pgm: byte 9: expected a pixel as a whole number from 0 to 9, found \"10\"");
  EXPECT_EQ(pgm_error("P2 2 1 9 1"),
            "a.pgm: byte 10: expected a pixel as a whole number from 0 to 9, found the end of the file");
  EXPECT_EQ(pgm_error("P5 2 2 255 abc"), "a.pgm: byte 11: expected 4 bytes of pixels, found 3");
  EXPECT_EQ(pgm_error("P5 1 1 10 \xFF"), "a.pgm: byte 10: pixel is 255, the largest value is 10");
  EXPECT_NE(pgm_error("P5 4294967296 4294967297 255 ").find("at most 1000"), std::string::npos);
}

TEST(Png, ShowsWhatThePgmShows) {
  const GrayImage pgm = read_pgm(sample("room.pgm"), "room.pgm", kMany);
  const GrayImage binary = read_pgm(sample("room_binary.pgm"), "room_binary.pgm", kMany);
  const GrayImage png = read_png(sample("room.png"), "room.png", kMany);
  EXPECT_EQ(pgm.samples, png.samples);
  EXPECT_EQ(pgm.samples, binary.samples);
  EXPECT_EQ(png.max_value, 255u);
  EXPECT_TRUE(png.transparent.empty());
}

// Bytes of hexadecimal digits.
std::string bytes_of(std::string_view digits) {
  const auto value = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  std::string bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    bytes += static_cast<char>(16 * value(digits[i]) + value(digits[i + 1]));
  return bytes;
}

TEST(Png, KeepsSixteenBitsAndSeesTransparency) {
  const std::string gray_and_alpha = bytes_of(
      "89504e470d0a1a0a0000000d49484452000000020000000110040000000ebb6b420000000f49444154789c63607ef11f"
      "04fe01001b6306e5b32320070000000049454e44ae426082");
  const GrayImage image = read_png(gray_and_alpha, "a.png", kMany);
  EXPECT_EQ(image.max_value, 65535u);
  EXPECT_EQ(image.samples, (std::vector<std::uint16_t>{1000, 65535}));
  EXPECT_EQ(image.transparent, (std::vector<bool>{false, true}));
}

TEST(Png, TurnsColorsAndSingleBitsToGray) {
  const std::string white_and_black = bytes_of(
      "89504e470d0a1a0a0000000d49484452000000020000000108020000007b40e8dd0000000f49444154789c63f8ffff3f"
      "030303000ef802fec98b83f50000000049454e44ae426082");
  EXPECT_EQ(read_png(white_and_black, "a.png", kMany).samples, (std::vector<std::uint16_t>{255, 0}));
  const std::string bits = bytes_of(
      "89504e470d0a1a0a0000000d4948445200000004000000010100000000d14732600000000a49444154789c6358000000"
      "a200a1dc8db1cc0000000049454e44ae426082");
  EXPECT_EQ(read_png(bits, "a.png", kMany).samples, (std::vector<std::uint16_t>{255, 0, 255, 0}));
}

TEST(Png, ErrorsNameTheFile) {
  std::string png = sample("room.png");
  EXPECT_NE(test::format_error_of([&] { read_png(png, "room.png", 100); }).find("room.png: PNG: more pixels"),
            std::string::npos);
  EXPECT_NE(test::format_error_of([&] { read_png(png.substr(0, 60), "room.png", kMany); }).find("ends too early"),
            std::string::npos);
  png[45] = static_cast<char>(png[45] ^ 1);
  EXPECT_NE(test::format_error_of([&] { read_png(png, "room.png", kMany); }), "no error");
}

}  // namespace
}  // namespace arcway::internal
