#include "accel/wedge/strips.h"

#include <utility>

#include "core/geometry/predicates.h"
#include "core/prefetch.h"

namespace arcway {

namespace {

using Strip = Strips::Strip;

class Tracer {
 public:
  explicit Tracer(const SightMap& map) : doors_(map.doors()), nodes_(map.nodes()), is_plain_(map.is_plain()) {}

  /// The only door that leads on behind a door, past a wall whose end has a plain node; kNone otherwise.
  [[nodiscard]] std::uint32_t onward(std::uint32_t door) const {
    const SightMap::Door& triangle = doors_[door];
    if ((triangle.left == kNone) == (triangle.right == kNone)) return kNone;
    if (triangle.node == kNone || !(is_plain_ || nodes_[triangle.node].is_plain())) return kNone;
    return triangle.left == kNone ? triangle.right : triangle.left;
  }

  /// Whether strips begin at a door: it is no wall, and not where another one leads on to.
  [[nodiscard]] bool is_entrance(std::uint32_t door) const {
    if (onward(door) == kNone) return false;
    const std::uint32_t back = doors_[Triangulation::next(door)].left;
    if (back == kNone) return false;
    const bool by_left = doors_[back].left != kNone;
    if (by_left == (doors_[back].right != kNone)) return true;
    return onward(by_left ? Triangulation::previous(back) : Triangulation::next(back)) != door;
  }

  /// The longest strip behind a door; its exit is the door itself if there is none.
  Strip trace(std::uint32_t door, std::vector<std::uint32_t>& turns) const {
    Strip strip{door, 0, 0, 0, 0, static_cast<std::uint32_t>(turns.size())};
    bool leads_right[2] = {};  // by side of the wall, in which direction it is followed
    for (std::uint32_t next = onward(door); next != kNone; next = onward(next)) {
      const SightMap::Door& triangle = doors_[strip.exit];
      const bool is_left = triangle.left == kNone;
      const std::uint32_t end = is_left ? Triangulation::next(strip.exit) : Triangulation::previous(strip.exit);
      const bool goes_right = doors_[end].site < triangle.site;
      std::uint32_t& first = is_left ? strip.first_left : strip.first_right;
      std::uint32_t& count = is_left ? strip.left_count : strip.right_count;
      if (count == 0) {
        first = triangle.node;
        leads_right[is_left] = goes_right;
      } else {
        const bool follows = triangle.node == (is_left ? first + count : first - count);  // not where the ring begins
        if (!follows || goes_right != leads_right[is_left]) break;
      }
      if (is_left) turns.push_back(strip.right_count);
      ++count;
      strip.exit = next;
    }
    return strip;
  }

 private:
  std::span<const SightMap::Door> doors_;
  std::span<const SightMap::Node> nodes_;
  bool is_plain_;
};

bool has_long_walls(const World& world) {
  constexpr std::ptrdiff_t kLong = 64;
  const std::span<const VertexId> convex = world.convex_vertices();
  std::ptrdiff_t count = 0;
  for (ObstacleId o = 0; o < world.region_count(); ++o) {
    const auto [first, last] = world.vertices_of(o);
    const std::ptrdiff_t size = last - first;
    if (size < kLong) continue;
    const auto turns =
        std::lower_bound(convex.begin(), convex.end(), last) - std::lower_bound(convex.begin(), convex.end(), first);
    if (10 * turns >= 9 * size) count += size;
  }
  return 2 * count > std::ssize(world.vertices());
}

}  // namespace

int Strips::Wall::turn(const Vec2& s, const Vec2& p, const Vec2& q) const { return step * orientation(s, p, q); }

// Seen from a point before the strip, nodes of a convex wall come nearer to the other wall one after the other, up to
// the one that limits what is seen, and then lie behind it; or all of them lie behind the end of the door. From the
// other wall the last node that was passed is in sight.
std::uint32_t Strips::Wall::limit_from(const Vec2& s, std::uint32_t nodes, std::uint32_t passed,
                                       std::uint32_t guess) const {
  if (nodes == 0) return kNone;
  const auto fetch = [this](std::uint32_t i) {
    will_need(&node(i).at);
    will_need(step > 0 ? &node(i).next : &node(i).previous);
  };
  if (passed == 0 && turn(s, step > 0 ? first->previous : first->next, first->at) >= 0) return kNone;
  std::uint32_t low = std::max(passed, 1u) - 1, high = nodes - 1;
  std::uint32_t far = guess == kNone ? nodes : 1;  // how far from the last one the next one is looked for
  std::uint32_t middle = guess == kNone ? low + (high - low) / 2 : std::clamp(guess, low, std::max(high, low + 1) - 1);
  for (; low < high; far = std::min(2 * far, nodes)) {
    // Where it goes on from here, either way.
    const std::uint32_t ahead = middle + 1 + std::min(far - 1, (high - middle - 1) / 2);
    const std::uint32_t back = middle - std::min(far, (middle - low + 1) / 2);
    fetch(ahead);
    fetch(back);
    const SightMap::Node& n = node(middle);
    const bool is_ahead = turn(s, n.at, step > 0 ? n.next : n.previous) < 0;
    if (is_ahead)
      low = middle + 1;
    else
      high = middle;
    middle = is_ahead ? ahead : back;
  }
  return low;
}

Strips::Strips(const SightMap& map, std::uint32_t least, const Executor& executor) {
  constexpr std::size_t kGrain = 1 << 16;
  struct Part {
    std::vector<std::pair<std::uint32_t, Strip>> strips;  // by door
    std::vector<std::uint32_t> turns;
  };
  const Tracer tracer(map);
  std::vector<Part> parts(map.doors().size() / kGrain + 1);
  executor.for_ranges(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      Part& part = parts[p];
      const std::size_t behind = std::min((p + 1) * kGrain, map.doors().size());
      for (auto first = static_cast<std::uint32_t>(p * kGrain); first < behind; ++first) {
        if (!tracer.is_entrance(first)) continue;
        for (std::uint32_t door = first; tracer.onward(door) != kNone;) {
          const Strip strip = tracer.trace(door, part.turns);
          if (strip.left_count + strip.right_count >= least) {
            part.strips.emplace_back(door, strip);
          } else {
            part.turns.resize(strip.first_turn);
          }
          door = strip.exit;
        }
      }
    }
  });

  std::vector<std::pair<std::uint32_t, Strip>> all;
  for (Part& part : parts) {
    for (auto& [door, strip] : part.strips) {
      strip.first_turn += static_cast<std::uint32_t>(turns_.size());
      all.emplace_back(door, strip);
    }
    turns_.insert(turns_.end(), part.turns.begin(), part.turns.end());
  }
  if (all.empty()) return;
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  marks_.resize(map.doors().size() / kDoorsPerMark + 1);
  strips_.reserve(all.size());
  for (const auto& [door, strip] : all) {
    marks_[door / kDoorsPerMark].doors |= std::uint64_t{1} << door % kDoorsPerMark;
    strips_.push_back(strip);
  }
  std::uint32_t before = 0;
  for (Mark& mark : marks_) {
    mark.before = before;
    before += static_cast<std::uint32_t>(std::popcount(mark.doors));
  }
}

Strips worthwhile_strips(const World& world, const SightMap& map, const Executor& executor) {
  constexpr std::uint32_t kLeast = 16;
  return has_long_walls(world) ? Strips(map, kLeast, executor) : Strips();
}

}  // namespace arcway
