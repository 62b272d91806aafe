#include "core/model/pose_text.h"

namespace arcway::internal {

std::string shortest_text(const Vec2& p) { return "(" + shortest_text(p.x()) + ", " + shortest_text(p.y()) + ")"; }

std::string shortest_text(const Pose& pose) {
  return "(" + shortest_text(pose.x) + ", " + shortest_text(pose.y) + ", " + shortest_text(pose.heading) + ")";
}

}  // namespace arcway::internal
