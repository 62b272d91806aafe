#include "arcway/datasets/moving_io.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "arcway/datasets/file_io.h"

namespace arcway::internal {
namespace {

std::string refusal_of(const std::string& text) {
  try {
    (void)parse_moving_obstacles(text, "m.json");
  } catch (const FormatError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(MovingIo, ReadsObstacles) {
  const std::vector<MovingObstacle> read = parse_moving_obstacles(
      R"({"format":"arcway-moving","version":1,"obstacles":[
          {"outline":[[0,0],[1,0],[1,2],[0,0]],"velocity":[0.5,-1],"from":2,"until":7.5},
          {"outline":[[3,0],[4,0],[4,1]],"velocity":[0,0]}]})",
      "m.json");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].outline.size(), 3u) << "the repeated vertex";
  EXPECT_EQ(read[0].outline[2], Vec2(1.0, 2.0));
  EXPECT_EQ(read[0].velocity, Vec2(0.5, -1.0));
  EXPECT_EQ(read[0].from, 2.0);
  EXPECT_EQ(read[0].until, 7.5);
  EXPECT_EQ(read[1].from, 0.0);
  EXPECT_EQ(read[1].until, std::numeric_limits<double>::infinity());
}

TEST(MovingIo, RefusalsNameThePlace) {
  EXPECT_EQ(refusal_of(R"({"obstacles":[{"outline":[[0,0],[1]],"velocity":[0,0]}]})"),
            "m.json: obstacles[0].outline[1]: expected two numbers, found [1]");
  EXPECT_NE(refusal_of(R"({"obstacles":[{"outline":[],"velocty":[0,0]}]})").find("velocty"), std::string::npos);
  EXPECT_NE(refusal_of(R"({"format":"arcway-plan","version":1,"obstacles":[]})").find("arcway-plan"),
            std::string::npos);
  EXPECT_EQ(refusal_of(R"({"obstacles":[]})"), "accepted");
}

}  // namespace
}  // namespace arcway::internal
