#pragma once

#include <cstdint>
#include <span>

#include "arcway/export.h"
#include "arcway/vec2.h"

namespace arcway {

/// Which segments are lines of sight? A segment is visible if no point of it lies strictly inside
/// an obstacle or strictly outside the bounds (World's rule of touching). Exact, whatever the
/// implementation: two implementations give the same answer to every question.
/// Thread-safe; a call does not allocate.
class ARCWAY_API VisibilityQuery {
 public:
  virtual ~VisibilityQuery() = default;

  /// visible[i] = 1 if segments[i] is a line of sight, else 0. Segments may be single points.
  /// Coordinates must be finite and in the range of predicates.h.
  /// @throws std::invalid_argument if the sizes differ or a coordinate is out of range, naming its index.
  void visible(std::span<const LineSegment> segments, std::span<std::uint8_t> visible) const;
  [[nodiscard]] bool visible(const LineSegment& segment) const;

 private:
  virtual void do_visible(std::span<const LineSegment> segments, std::span<std::uint8_t> visible) const = 0;
};

}  // namespace arcway
