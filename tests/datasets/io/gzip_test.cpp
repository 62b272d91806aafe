#include "datasets/io/gzip.h"

#include <gtest/gtest.h>

#include "arcway/datasets/file_io.h"
#include "tests/support/format_errors.h"

namespace arcway::internal {
namespace {

// "0 0 1 0 1 1\n", compressed.
const std::string kTriangle(
    "\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\x03\x33\x50\x30\x50"
    "\x30\x04\x63\x43\x2e\x00\x79\x0a\x51\x16\x0c\x00\x00\x00",
    28);

TEST(Gzip, Expands) {
  EXPECT_TRUE(is_gzip(kTriangle));
  EXPECT_FALSE(is_gzip("0 0"));
  EXPECT_EQ(expand_gzip(kTriangle, "a.gz"), "0 0 1 0 1 1\n");
  EXPECT_EQ(expand_gzip(kTriangle + kTriangle, "a.gz"), "0 0 1 0 1 1\n0 0 1 0 1 1\n");
}

TEST(Gzip, SkipsZerosBehindTheLastMemberAndNothingElse) {
  const std::string zeros(1000, '\0');
  EXPECT_EQ(expand_gzip(kTriangle + zeros, "a.gz"), "0 0 1 0 1 1\n");
  EXPECT_EQ(expand_gzip(kTriangle + kTriangle + zeros.substr(0, 1), "a.gz"), "0 0 1 0 1 1\n0 0 1 0 1 1\n");
  const auto error_of = [](const std::string& bytes) {
    return test::format_error_of([&] { expand_gzip(bytes, "a.gz"); });
  };
  const std::string other = "a.gz: gzip: byte 28: neither another member nor zeros";
  EXPECT_EQ(error_of(kTriangle + "garbage"), other);
  EXPECT_EQ(error_of(kTriangle + "\x1f"), other);
  EXPECT_EQ(error_of(kTriangle + zeros + "x"), other);
  EXPECT_EQ(error_of(kTriangle + zeros + kTriangle), other);
  EXPECT_EQ(error_of(kTriangle + kTriangle.substr(0, 9)), "a.gz: gzip: the file ends too early");
}

TEST(Gzip, DamagedFilesAreErrors) {
  for (std::size_t size = 2; size < kTriangle.size(); ++size)
    EXPECT_THROW(expand_gzip(std::string_view(kTriangle).substr(0, size), "a.gz"), FormatError) << size;
  EXPECT_THROW(expand_gzip(kTriangle, "a.gz", 5), FormatError);
  std::string damaged = kTriangle;
  damaged[12] = static_cast<char>(damaged[12] ^ 4);
  EXPECT_THROW(expand_gzip(damaged, "a.gz"), FormatError);
}

}  // namespace
}  // namespace arcway::internal
