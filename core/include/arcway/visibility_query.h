#pragma once

#include <cstdint>
#include <span>

#include "arcway/export.h"
#include "arcway/vec2.h"

namespace arcway {

/// Whether segments are lines of sight. A segment is one if no point of it lies strictly inside an obstacle or strictly
/// outside the bounds: see "Touching" at World. Exact: all implementations give the same answers. Thread-safe; a call
/// does not allocate.
class ARCWAY_API VisibilityQuery {
 public:
  virtual ~VisibilityQuery() = default;

  /// visible[i] = 1 if segments[i] is a line of sight, else 0. A segment may be a single point. Coordinates must be
  /// in the exact range of vec2.h [m].
  /// @throws std::invalid_argument if the sizes differ or a coordinate is out of range, naming its index.
  void visible(std::span<const LineSegment> segments, std::span<std::uint8_t> visible) const;
  [[nodiscard]] bool visible(const LineSegment& segment) const;

 private:
  virtual void do_visible(std::span<const LineSegment> segments, std::span<std::uint8_t> visible) const = 0;
};

}  // namespace arcway
