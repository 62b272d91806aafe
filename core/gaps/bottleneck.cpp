#include "arcway/bottleneck.h"

#include "core/gaps/bottleneck_finder.h"

namespace arcway {

using namespace internal;

namespace {

std::string text_of(const Vec2& p) { return "(" + rounded_text(p.x()) + ", " + rounded_text(p.y()) + ")"; }

}  // namespace

std::string Bottleneck::text(const World& world) const {
  const std::string a = region_text(world, obstacle_a), b = region_text(world, obstacle_b);
  if (width == 0.0)
    return obstacle_a == obstacle_b ? a + " lies all around start or goal, or meets itself at " + text_of(on_a)
                                    : a + " and " + b + " meet at " + text_of(on_a) + " and leave no way";
  const std::string place = obstacle_a == obstacle_b
                                ? "between two sides of " + a + " at " + text_of(on_a) + " and " + text_of(on_b)
                                : "between " + a + " at " + text_of(on_a) + " and " + b + " at " + text_of(on_b);
  return "the widest route narrows to " + rounded_text(width) + " m " + place;
}

}  // namespace arcway
