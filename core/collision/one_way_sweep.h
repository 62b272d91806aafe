#pragma once

#include <memory>
#include <span>
#include <vector>

#include "arcway/sweep_query.h"
#include "core/zones/one_way_zones.h"

namespace arcway::internal {

/// A sweep query that also refuses motions against one-way zones. Headings at which F would drive against one are not
/// free, and neither are lines that do. Bodies that stand, and swept rectangles alone, have no direction: they are free
/// as in the query that it wraps. Proofs that no path exists ask about rectangles, and so are about obstacles. As exact
/// as that query, and OneWayZones.
class OneWaySweep final : public SweepQuery {
 public:
  /// @param forwards  the gear in which motions are driven that are asked for as driven forwards. kReverse serves
  ///   searches for paths in reverse, which are described as driven forwards from goal to start.
  OneWaySweep(std::shared_ptr<const SweepQuery> base, std::shared_ptr<const OneWayZones> zones, Gear forwards)
      : base_(std::move(base)), zones_(std::move(zones)), forwards_(forwards) {}

 private:
  void do_straights_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const override;
  void do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const override;
  void do_straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const override;
  void do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const override;
  [[nodiscard]] bool do_arc_free(const TurningBody& body, double heading, double angle,
                                 HeadingSet& headings) const override;
  [[nodiscard]] double do_reach(const TurningBody& body, double heading, Side towards,
                                HeadingSet& headings) const override;
  [[nodiscard]] Gear driven(Gear gear) const;

  std::shared_ptr<const SweepQuery> base_;
  std::shared_ptr<const OneWayZones> zones_;
  Gear forwards_;
};

/// The sweep query itself without zones, else one that obeys them.
/// @param zones  may be null.
/// @param forwards  see OneWaySweep.
std::shared_ptr<const SweepQuery> obeying(const std::shared_ptr<const SweepQuery>& sweep,
                                          const std::shared_ptr<const OneWayZones>& zones,
                                          Gear forwards = Gear::kForward);

}  // namespace arcway::internal
