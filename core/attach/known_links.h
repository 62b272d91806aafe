#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/attach/attachment_links.h"
#include "core/attach/roadmap.h"
#include "core/base/huge_pages.h"

namespace arcway::internal {

/// The straights between start, goal and roadmap that the searches of one query have found. Searches on one graph share
/// them. One on a graph with fewer of its radii takes its part: such a graph has no other circles. Finding straights is
/// a third of a short query. Keeps none at first; its memory is kept.
class KnownLinks {
 public:
  /// Forgets all straights, and keeps those of searches from now on.
  void begin();
  /// Appends the straights of a circle as AttachmentLinks::append_links does, but for such as are not free.
  /// @param index  of the circle, for the links.
  /// @return false if they are not known.
  bool append(const PathEnd& end, const AttachmentCircle& own, const LengthLimit& limit, std::uint32_t index,
              HugeVector<AttachmentLink>& links) const;
  /// Keeps the straights of a circle that has been found to have them, from links[first] on.
  void keep(const PathEnd& end, const AttachmentCircle& own, const LengthLimit& limit,
            const HugeVector<AttachmentLink>& links, std::size_t first);
  /// The number of circles whose straights are known.
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  // What the straights of one circle depend on.
  struct Entry {
    std::weak_ptr<const CircleTable> circles;  // weak, as other tables may lie at the same address later
    std::weak_ptr<const FeasibleGraph> graph;
    std::weak_ptr<const VehicleGaps> gaps;  // of the world and the vehicle; a slim body has those of the real one
    Footprint body{};
    std::weak_ptr<const SweepQuery> sweep;
    CircleRadii radii;
    Direction direction = Direction::kFromStart;
    AttachmentCircle own{};
    Vec2 other_end{0.0, 0.0};
    double length = 0.0;  // see LengthLimit
    HugeVector<AttachmentLink> links;
  };
  static bool append_from(const Entry& entry, const Roadmap& map, const LengthLimit& limit, std::uint32_t index,
                          HugeVector<AttachmentLink>& links);

  bool keeps_ = false;
  std::size_t size_ = 0;   // of the entries, the first so many are in use
  std::size_t links_ = 0;  // of these
  std::vector<Entry> entries_;
};

}  // namespace arcway::internal
