#pragma once

#include <cstdint>

#include "core/attach/search_context.h"
#include "core/motion/speed_tree.h"

namespace arcway::internal {

/// The times of the paths that a search tries: its tree of speeds, by arcs, lines and connections of attachments.
class SearchTimes {
 public:
  /// Forgets the search before, or goes on from it.
  void begin(const SearchContext& context, bool warm_start);

  void reserve(std::size_t joints) { speeds_.reserve(joints); }
  void warm_up(std::size_t joints) { speeds_.warm_up(joints); }
  [[nodiscard]] const SpeedTree& speeds() const { return speeds_; }
  /// Forgets the joints added last.
  void truncate(std::size_t size) { speeds_.truncate(size); }

  /// The joint at the end of a start attachment's connection, which leads to its circle.
  std::uint32_t add_connection(const AttachmentCircle& from);
  /// The joint behind an arc and the line after it, which leads to a circle of another radius.
  std::uint32_t add_drive(std::uint32_t joint, double arc, double radius, double line, double next_radius);
  /// What add_drive gives, not added to the tree.
  [[nodiscard]] SpeedTree::Joint drive(std::uint32_t joint, double arc, double radius, double line,
                                       double next_radius) const;
  /// The exact time of the whole path that goes on from a joint by an arc, a link to a goal's circle, and what follows.
  double time_to_goal(std::uint32_t joint, double arc, double radius, const AttachmentLink& link,
                      const AttachmentCircle& to);

 private:
  // What matters of a segment for the speeds.
  struct Stretch {
    double length;
    double limit;
    Gear gear;
  };
  [[nodiscard]] Stretch stretch_of(const PathSegment& segment) const;
  std::uint32_t add_stretch(std::uint32_t joint, const Stretch& stretch, const Stretch& next);

  const SearchContext* context_ = nullptr;
  double line_speed_ = 0.0;
  SpeedTree speeds_;
};

}  // namespace arcway::internal
