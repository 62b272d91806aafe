#pragma once

#include <optional>

#include "arcway/stop_clock.h"
#include "core/attach/roadmap.h"
#include "core/base/late_value.h"

namespace arcway::internal {

/// A roadmap with added circles in narrow gaps, see find_gap_circles. If there are such gaps, but only one radius, and
/// v_mc does not depend on the radius, it also has circles four times as wide around all vertices. Made when first
/// asked for. Thread-safe.
class NarrowPlaces {
 public:
  /// @param map  must outlive this.
  explicit NarrowPlaces(const Roadmap& map) : map_(map) {}

  /// The roadmap with a lazy graph that has all straights of the given one and more. The given roadmap itself if the
  /// map has no narrow gaps, or if the clock is over before they are known. The first call takes as long as GapMap.
  [[nodiscard]] const Roadmap& map(const StopClock& clock = {}) const;

 private:
  const Roadmap& map_;
  LateValue<std::optional<Roadmap>> detailed_;  // nothing where there is no narrow place
};

}  // namespace arcway::internal
