#pragma once

#include <cstddef>
#include <cstdint>

#include "arcway/vehicle.h"
#include "core/attach/per_circle.h"
#include "core/attach/roadmap.h"
#include "core/base/huge_pages.h"
#include "core/base/prefetch.h"
#include "core/search/search_times.h"

namespace arcway::internal {

/// An arrival on a circle of the graph by some path.
struct ArrivalLabel {
  std::uint32_t circle;
  std::uint32_t number;  ///< among the labels on the circle
  double radius;         ///< of the circle
  double heading;
  double reach;  ///< of the free interval
  std::uint32_t joint;
  std::uint32_t parent;  ///< the label before; kNone: a start link leads here
  std::uint32_t index;   ///< of the graph link among those of the parent's circle, or of the start link
  std::uint32_t next;    ///< the label before on the same circle
};

/// The labels of a search. Memory is kept for the next one.
class ArrivalLabels {
 public:
  /// Forgets all labels. Those to come are on circles 0, ..., circles - 1.
  /// @param enough  number of labels that memory is reserved for.
  void reset(std::size_t circles, std::size_t enough);
  /// Forgets all labels, and takes memory for those of a search.
  void warm_up(std::size_t circles, std::size_t labels);

  [[nodiscard]] bool empty() const { return labels_.empty(); }
  [[nodiscard]] std::size_t size() const { return labels_.size(); }
  [[nodiscard]] const ArrivalLabel& operator[](std::uint32_t label) const { return labels_[label]; }
  /// The label on a circle that was added last, or kNone. The others follow by `next`.
  [[nodiscard]] std::uint32_t last_on(std::uint32_t circle) const { return last_.get(circle); }
  void prefetch(std::uint32_t label) const { will_need(&labels_[label]); }
  void prefetch_on(std::uint32_t circle) const { last_.prefetch(circle); }

  /// Makes a label the next one on its circle: sets its number, and the label before.
  void follow(ArrivalLabel& label) const;
  /// Adds a label that follows. Returns its index.
  std::uint32_t add(const ArrivalLabel& label);

 private:
  HugeVector<ArrivalLabel> labels_;
  PerCircle last_;
};

/// Which labels go on at least as well as others at every speed. See ArrivalSearch.
class ArrivalDominance {
 public:
  /// Labels of the search before, the first ones: they also dominate others that gain less than this.
  struct Known {
    std::size_t labels;
    double least_gain;  ///< [s]
  };

  /// All must outlive this.
  ArrivalDominance(const ArrivalLabels& labels, SearchTimes& times, const Roadmap& map, const Vehicle& vehicle)
      : labels_(labels), times_(times), map_(map), vehicle_(vehicle) {}

  /// How far a label that follows can turn before an older one does as well; negative if that is so from the beginning.
  /// Linear in the labels on its circle.
  [[nodiscard]] double undominated_turn(const ArrivalLabel& label, Side side, const Known& known) const;

 private:
  struct Turned {
    SpeedTree::Joint joint;
    double cost;  // of driving close to obstacles up to there [s]
  };
  // The joint of a label after a turn on its circle. Where costs depend on places, it lies behind joints that the
  // caller forgets.
  [[nodiscard]] Turned turned(const ArrivalLabel& label, double turn, double speed) const;

  const ArrivalLabels& labels_;
  SearchTimes& times_;
  const Roadmap& map_;
  const Vehicle& vehicle_;
};

}  // namespace arcway::internal
