#include "core/collision/swept_shape.h"

#include <span>

#include "core/geometry/convex_prism.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {

SweptShape::SweptShape(const StraightBody& body, Memory& memory)
    : body_(body),
      along_(direction_of(body.from.heading)),
      bounds_(swept_rectangle(body.from, body.length, body.body)),
      memory_(memory) {
  memory_.ends.clear();
}

bool SweptShape::meets(const LineSegment& edge) const {
  if (!intersects(edge, bounds_)) return false;
  if (memory_.ends.empty()) find_prisms();
  std::size_t first = 0;
  for (const std::size_t end : memory_.ends) {
    if (meets_convex(edge, std::span(memory_.corners).subspan(first, end - first))) return true;
    first = end;
  }
  return false;
}

void SweptShape::find_prisms() const {
  Memory& m = memory_;
  m.corners.clear();
  for (const Ring& piece : body_.body.shape->pieces) {
    m.from.clear(), m.to.clear(), m.ahead.clear();
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const double rise = piece[i + 1 < piece.size() ? i + 1 : 0].y() - piece[i].y();
      m.ahead.push_back(static_cast<signed char>((rise > 0.0) - (rise < 0.0)));
      m.from.push_back(place(piece[i], 0.0));
      if (body_.length > 0.0) m.to.push_back(place(piece[i], body_.length));
    }
    convex_prism(m.from, body_.length > 0.0 ? m.to : m.from, m.ahead, m.prism);
    m.corners.insert(m.corners.end(), m.prism.begin(), m.prism.end());
    m.ends.push_back(m.corners.size());
  }
}

}  // namespace arcway::internal
