#include "datasets/io/nearest_word.h"

#include <gtest/gtest.h>

#include <vector>

namespace arcway::internal {
namespace {

const std::vector<std::string_view> kWords{"length", "width", "wheelbase", "max_speed", "s"};

TEST(NearestWord, FindsWhatWasMeant) {
  EXPECT_EQ(nearest_word("widht", kWords), "width");
  EXPECT_EQ(nearest_word("wheel_base", kWords), "wheelbase");
  EXPECT_EQ(nearest_word("Length", kWords), "length");
  EXPECT_EQ(nearest_word("speed", kWords), "max_speed");
  EXPECT_EQ(nearest_word("max_speed_mps", kWords), "max_speed");
  EXPECT_EQ(nearest_word("color", kWords), "");
  EXPECT_EQ(nearest_word("", kWords), "");
  EXPECT_EQ(nearest_word("x", kWords), "");
  EXPECT_EQ(nearest_word("width", {}), "");
}

TEST(NearestWord, MessagesAreShort) {
  EXPECT_EQ(unknown_word("key", "widht", kWords),
            "unknown key \"widht\", did you mean \"width\"? There are length, width, wheelbase, max_speed, s");
  EXPECT_EQ(unknown_word("key", "\x01q", kWords),
            "unknown key \"?q\"; there are length, width, wheelbase, max_speed, s");
  EXPECT_LT(unknown_word("key", std::string(1 << 20, 'w'), kWords).size(), 200u);
}

TEST(NearestWord, SynonymsComeBeforeWordsThatLookAlike) {
  constexpr Synonym kSynonyms[] = {{"maxvelocity", "max_speed"}, {"wheels", "width"}};
  for (const char* word : {"max_velocity", "maxVelocity", "MAX-VELOCITY"})
    EXPECT_NE(unknown_word("key", word, kWords, kSynonyms).find("did you mean \"max_speed\"?"), std::string::npos)
        << word;
  EXPECT_NE(unknown_word("key", "wheels", kWords, kSynonyms).find("did you mean \"width\"?"), std::string::npos);
  EXPECT_NE(unknown_word("key", "wheelbas", kWords, kSynonyms).find("did you mean \"wheelbase\"?"), std::string::npos);
}

}  // namespace
}  // namespace arcway::internal
