#include "core/attach/circle_places.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "arcway/executor.h"
#include "core/roadmap/slot_cache.h"

namespace arcway::internal {

namespace {

void extend_by(Box& box, const TurnCircle& circle) {
  const Vec2 half(circle.radius, circle.radius);
  box.extend(circle.center - half);
  box.extend(circle.center + half);
}

Box box_of(const Outlines::Piece& piece, const TurnCircles& circles) {
  Box box = piece.box;
  for (std::size_t k = 0; k < piece.edge_count(); ++k)
    circles.visit_by_first(static_cast<VertexId>(piece.first + k),
                           [&](std::uint32_t c) { extend_by(box, circles.all()[c]); });
  return box;
}

bool contains(const Box& box, const Box& part) { return box.contains(part.min) && box.contains(part.max); }

}  // namespace

// What differs from the pieces and circles that were built.
struct CirclePlaces::Changed {
  explicit Changed(std::shared_ptr<const FeasibleGraph> the_graph, std::size_t piece_count)
      : graph(std::move(the_graph)), found(piece_count) {}

  std::shared_ptr<const FeasibleGraph> graph;
  std::vector<std::uint32_t> pieces;  // that are not found by the tree that was built, ascending
  BoxTree tree;                       // of these
  SlotCache<Built> found;             // circles by piece
};

Box CirclePlaces::Built::append(const Outlines::Piece& piece, const TurnCircles& of) {
  struct Sized {
    int magnitude;  // of the radius
    std::uint32_t circle;
  };
  static thread_local std::vector<Sized> here;  // memory
  here.clear();
  for (std::size_t k = 0; k < piece.edge_count(); ++k)
    of.visit_by_first(static_cast<VertexId>(piece.first + k), [&](std::uint32_t c) {
      here.push_back({std::ilogb(of.all()[c].radius), c});
    });
  std::ranges::sort(here, {}, [](const Sized& sized) { return std::pair(sized.magnitude, sized.circle); });
  const std::size_t first = groups.size();
  for (std::size_t k = 0; k < here.size(); ++k) {
    const auto at = static_cast<std::uint32_t>(circles.size());
    if (k == 0 || here[k].magnitude != here[k - 1].magnitude) groups.push_back({at, at, Box()});
    Group& group = groups.back();
    group.last = at + 1;
    circles.push_back(here[k].circle);
    extend_by(group.box, of.all()[here[k].circle]);
  }
  first_group.push_back(static_cast<std::uint32_t>(groups.size()));
  Box box = piece.box;
  for (std::size_t g = first; g < groups.size(); ++g) box.extend(groups[g].box);
  return box;
}

CirclePlaces::CirclePlaces(const TurnCircles& circles, const std::shared_ptr<const Outlines>& outlines,
                           const StopClock& clock)
    : outlines_(outlines, &outlines->as_new()) {
  const Outlines& pieces = *outlines_;
  auto built = std::make_shared<Built>();
  built->circles.reserve(circles.all().size());
  built->groups.reserve(pieces.size());
  built->first_group.reserve(pieces.size() + 1);
  HugeVector<Box> boxes(pieces.size());
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    if (clock.is_over()) throw Canceled("canceled");
    boxes[i] = built->append(pieces[i], circles);
  }
  built->tree = pieces.tree().with_boxes(boxes);
  built_ = std::move(built);
}

// A piece whose circles do not all lie in the box that was built is left to a tree of its own, as added ones are.
CirclePlaces::CirclePlaces(const CirclePlaces& before, std::shared_ptr<const FeasibleGraph> graph,
                           std::shared_ptr<const Outlines> outlines, std::span<const VertexId> may_differ)
    : outlines_(std::move(outlines)), built_(before.built_) {
  const Outlines& pieces = *outlines_;
  const auto built_count = static_cast<std::uint32_t>(pieces.built_count());
  std::vector<std::uint32_t> doubtful;
  for (const std::uint32_t i : before.other_pieces())
    if (i < built_count && pieces.has(i)) doubtful.push_back(i);
  for (const VertexId v : may_differ) doubtful.push_back(pieces.index_of(v));
  for (std::uint32_t i = built_count; i < pieces.size(); ++i) doubtful.push_back(i);
  std::ranges::sort(doubtful);
  doubtful.erase(std::unique(doubtful.begin(), doubtful.end()), doubtful.end());
  auto changed = std::make_shared<Changed>(std::move(graph), pieces.size());
  std::vector<Box> boxes;
  for (const std::uint32_t i : doubtful) {
    const Box box = box_of(pieces[i], changed->graph->turn_circles());
    Box built_box;
    if (i < built_count) {
      built_box = pieces[i].box;
      for (const Group& group : built_->groups_of(i)) built_box.extend(group.box);
      if (contains(built_box, box)) continue;
    }
    changed->pieces.push_back(i);
    boxes.push_back(box);
  }
  changed->tree = BoxTree(boxes);
  changed_ = std::move(changed);
}

bool CirclePlaces::is_in_built_tree(std::uint32_t piece) const {
  return outlines_->has(piece) && !std::ranges::binary_search(changed_->pieces, piece);
}

CirclePlaces::Circles CirclePlaces::found(std::uint32_t piece) const {
  const Built& here = changed_->found.get(piece, [&] {
    auto made = std::make_unique<Built>();
    made->append((*outlines_)[piece], changed_->graph->turn_circles());
    return std::unique_ptr<const Built>(std::move(made));
  });
  return {here.groups, here.circles};
}

const BoxTree& CirclePlaces::other_tree() const { return changed_->tree; }

std::span<const std::uint32_t> CirclePlaces::other_pieces() const {
  return changed_ ? std::span<const std::uint32_t>(changed_->pieces) : std::span<const std::uint32_t>();
}

}  // namespace arcway::internal
