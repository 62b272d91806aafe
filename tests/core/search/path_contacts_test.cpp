#include "core/search/path_contacts.h"

#include <gtest/gtest.h>

#include <vector>

#include "arcway/world.h"
#include "core/model/outlines.h"
#include "tests/support/boxes.h"

namespace arcway::internal {
namespace {

using test::box;

constexpr Footprint kPathBody{1.5, 0.5, 0.5, 0.5};

std::vector<PathSegment> chain(const Pose& start, const std::vector<PathSegment>& motions) {
  std::vector<PathSegment> path;
  Pose pose = start;
  for (const PathSegment& m : motions) {
    path.push_back({pose, m.length, m.curvature, m.gear});
    pose = path.back().end();
  }
  return path;
}

const std::vector<PathSegment> kMotions{
    {{}, 1.7, 0.1}, {{}, 2.2, 0.4}, {{}, 1.3, -0.7, Gear::kReverse}, {{}, 2.0, 1e-6}};

// Compares the gradients with differences of the end as each part changes a little.
TEST(PathContacts, EndGradientsAreThoseOfTheEnd) {
  const World world({box(30.0, 0.3, 31.0, 1.0)});
  const Outlines outlines(world);
  const PathContacts contacts(outlines, kPathBody);
  const std::vector<PathSegment> path = chain({1.0, 2.0, 0.5}, kMotions);
  const auto gradients = contacts.end_gradients(path);
  const Pose end = path.back().end();
  constexpr double kChange = 1e-7;
  for (std::size_t i = 0; i < 2 * kMotions.size(); ++i) {
    std::vector<PathSegment> changed = kMotions;
    if (i % 2 == 0) changed[i / 2].curvature += kChange / contacts.unit();
    if (i % 2 == 1) changed[i / 2].length += kChange * contacts.unit();
    const Pose now = chain({1.0, 2.0, 0.5}, changed).back().end();
    const auto column = gradients.col(static_cast<Eigen::Index>(i));
    EXPECT_NEAR((now.x - end.x) / (kChange * contacts.unit()), column(0), 1e-5) << i;
    EXPECT_NEAR((now.y - end.y) / (kChange * contacts.unit()), column(1), 1e-5) << i;
    EXPECT_NEAR((now.heading - end.heading) / kChange, column(2), 1e-5) << i;
  }
}

// A post that a side touches in the middle of an arc: its depth changes with what comes before, as its gradient says.
TEST(PathContacts, GradientsAreThoseOfTheDeepestContact) {
  for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
    const std::vector<PathSegment> motions{{{}, 2.0, 0.3, gear}, {{}, 3.0, -0.2, gear}};
    const std::vector<PathSegment> path = chain({0.0, 0.0, 0.0}, motions);
    const Pose middle = path[1].at(1.5);
    const Vec2 left = perpendicular(direction_of(middle.heading));
    const Vec2 tip = middle.position() + 0.48 * left;
    const World world({{{tip, tip + left + 0.1 * direction_of(middle.heading), tip + left}, {}}});
    const Outlines outlines(world);
    PathContacts contacts(outlines, kPathBody);
    const auto deepest_of = [&](const std::vector<PathSegment>& of) {
      contacts.look_along(chain({0.0, 0.0, 0.0}, of), path.back().end());
      Eigen::Index row = 0;
      contacts.residuals().values.head(contacts.residuals().values.size() - 3).maxCoeff(&row);
      return row;
    };
    const Eigen::Index row = deepest_of(motions);
    const LinearResiduals at = contacts.residuals();
    ASSERT_GT(at.values(row), 0.0);
    constexpr double kChange = 1e-4;
    for (std::size_t i = 0; i < 4; ++i) {
      std::vector<PathSegment> changed = motions;
      if (i % 2 == 0) changed[i / 2].curvature += kChange / contacts.unit();
      if (i % 2 == 1) changed[i / 2].length += kChange * contacts.unit();
      const double now = contacts.residuals().values(deepest_of(changed));
      EXPECT_NEAR((now - at.values(row)) / kChange, at.gradients(row, static_cast<Eigen::Index>(i)), 0.05) << i;
    }
  }
}

TEST(PathContacts, TellsHowDeepABodyLiesOverAPost) {
  const World world({box(3.0, 0.3, 3.1, 1.0)});
  const Outlines outlines(world);
  PathContacts contacts(outlines, kPathBody);
  const std::vector<PathSegment> line{{{0.0, 0.0, 0.0}, 8.0, 0.0}};
  contacts.look_along(line, line.back().end());
  EXPECT_NEAR(contacts.deepest() * contacts.unit(), 0.2, 1e-9);
}

// Steps at which an edge is far are left out. Along short motions there are none of these.
TEST(PathContacts, MissesNoPostThatIsFarAtFirst) {
  int touched = 0;
  for (int i = 0; i < 600; ++i) {
    const double x = 0.2 * (i % 30), y = 0.75 + 0.2 * (i / 30);
    const World world({box(x, y, x + 0.02, y + 0.02)});
    const Outlines outlines(world);
    PathContacts contacts(outlines, kPathBody), by_parts(outlines, kPathBody);
    const PathSegment arc{{0.0, 0.0, 0.0}, 7.0, 0.3};
    contacts.look_along({arc}, arc.end());
    const std::vector<PathSegment> parts = chain(arc.start, std::vector<PathSegment>(140, {{}, 0.05, 0.3}));
    by_parts.look_along(parts, parts.back().end());
    EXPECT_NEAR(contacts.deepest(), by_parts.deepest(), 1e-3) << i;
    touched += contacts.deepest() > 0.0 ? 1 : 0;
  }
  EXPECT_GT(touched, 50);
  EXPECT_LT(touched, 550);
}

TEST(PathContacts, KnowsTheWayFromTheGoal) {
  const World world({box(30.0, 0.3, 31.0, 1.0)});
  const Outlines outlines(world);
  PathContacts contacts(outlines, kPathBody);
  contacts.look_along({{{0.0, 0.0, 0.0}, 8.0, 0.0}}, {8.0, 0.5, 0.125});
  EXPECT_NEAR(contacts.off_goal(), 0.25, 1e-12);
  EXPECT_EQ(contacts.deepest(), 0.0);
}

}  // namespace
}  // namespace arcway::internal
