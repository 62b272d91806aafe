#include "core/attach/maneuvers.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "arcway/angle.h"
#include "core/base/open_list.h"
#include "core/collision/arc_query.h"

namespace arcway::internal {

namespace {

constexpr double kStepTurn = kPi / 8.0;
constexpr double kLeastTurn = 1e-3;
constexpr std::array kLineSteps{1.0, 4.0, 16.0};
constexpr std::array kShares{1.0, 0.75, 0.5, 0.25};  // shares of the turn up to an obstacle at which arcs end
constexpr std::size_t kStepsFromAPose = kLineSteps.size() + 2 * kShares.size();

// Poses in one cell count as the same.
struct Grid {
  double size;
  int headings;
};

using Cell = std::array<std::int64_t, 3>;

Cell cell_of(const Pose& pose, const Grid& grid) {
  return {std::llround(pose.x / grid.size), std::llround(pose.y / grid.size),
          std::llround(wrap_positive(pose.heading) / kTwoPi * grid.headings) % grid.headings};
}

struct Waiting {
  double length;  // of the connection
  std::size_t pose;
  friend bool before(const Waiting& a, const Waiting& b) {
    return a.length != b.length ? a.length < b.length : a.pose < b.pose;
  }
};

// A set of cells that keeps its memory when it is emptied.
class CellSet {
 public:
  // Empties the set and makes room for `most` cells.
  void begin(std::size_t most) { slots_.assign(std::bit_ceil(2 * most), Slot{}); }
  // False if the cell was in before.
  bool insert(const Cell& cell) {
    std::uint64_t hash = 0;
    for (const std::int64_t part : cell) hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9E3779B97F4A7C15u;
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = (hash >> 32) & mask;
    for (; slots_[at].used; at = (at + 1) & mask)
      if (slots_[at].cell == cell) return false;
    slots_[at] = {cell, true};
    return true;
  }

 private:
  struct Slot {
    Cell cell{};
    bool used = false;
  };
  std::vector<Slot> slots_;
};

}  // namespace

struct ManeuverWorkspace::Data {
  std::vector<Attachment> attachments;  // those of before have memory for connections
  std::vector<double> lengths;
  OpenList<Waiting> open;
  CellSet seen;
  HeadingSet headings;
};

ManeuverWorkspace::ManeuverWorkspace() : data_(std::make_unique<Data>()) {}
ManeuverWorkspace::~ManeuverWorkspace() = default;
ManeuverWorkspace::ManeuverWorkspace(ManeuverWorkspace&&) noexcept = default;
ManeuverWorkspace& ManeuverWorkspace::operator=(ManeuverWorkspace&&) noexcept = default;

std::span<const Attachment> find_maneuvers(const Pose& pose, Direction direction, const Vehicle& vehicle, double radius,
                                           const SweepQuery& sweep, std::size_t max_poses, Spread spread,
                                           ManeuverWorkspace& workspace, const StopClock& clock) {
  const bool forwards = direction == Direction::kFromStart;
  const Footprint body = vehicle.footprint(0.5 * vehicle.safety_margin());
  const double step = radius * kStepTurn;
  const Grid grid = spread == Spread::kDense ? Grid{0.5 * step, 128} : Grid{0.5 * radius, 32};

  ManeuverWorkspace::Data& w = *workspace;
  std::vector<Attachment>& attachments = w.attachments;
  std::vector<double>& lengths = w.lengths;
  OpenList<Waiting>& open = w.open;
  CellSet& seen = w.seen;
  lengths.clear();
  open.clear();
  seen.begin(max_poses + kStepsFromAPose);
  const auto add = [&](const Pose& reached, double length) -> Attachment& {
    if (attachments.size() == lengths.size()) attachments.emplace_back();
    Attachment& attachment = attachments[lengths.size()];
    attachment.pose = reached;
    attachment.connection.clear();
    attachment.shared.reset();
    open.push({length, lengths.size()});
    lengths.push_back(length);
    return attachment;
  };
  add(pose, 0.0);
  seen.insert(cell_of(pose, grid));

  const auto reach = [&](std::size_t from, const PathSegment& segment, const Pose& reached,
                         std::optional<Side> turned = {}) {
    if (!seen.insert(cell_of(reached, grid))) return;
    Attachment& attachment = add(reached, lengths[from] + segment.length);
    attachment.shared = turned;
    Path& connection = attachment.connection;
    const Path& before = attachments[from].connection;
    if (!forwards) connection.push_back(segment);
    connection.insert(connection.end(), before.begin(), before.end());
    if (forwards) connection.push_back(segment);
  };

  while (!open.empty() && lengths.size() < max_poses && !clock.is_over()) {
    const std::size_t at = open.pop().pose;
    const Pose here = attachments[at].pose;
    const Vec2 ahead = direction_of(here.heading);
    for (const double steps : kLineSteps) {
      const double length = steps * step;
      const Vec2 other = here.position() + (forwards ? length : -length) * ahead;
      const Pose reached{other.x(), other.y(), here.heading};
      const PathSegment line{forwards ? here : reached, length, 0.0};
      if (!sweep.straight_free(swept_rectangle(line.start, length, body))) break;
      reach(at, line, reached);
    }
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const Vec2 center = here.position() + sign_of(side) * radius * perpendicular(ahead);
      const TurningBody turning{center, radius, side, body};
      const Side towards = forwards ? side : opposite(side);
      const double room = internal::reach(sweep, turning, here.heading, towards, w.headings);
      // If an obstacle ends the turn early, free motions may leave from a narrow range of headings before its end.
      const bool cut_short = room < kStepTurn;
      for (const double share : kShares) {
        const double angle = cut_short ? share * room : kStepTurn;
        if (angle < kLeastTurn) break;
        const double turn = (forwards ? 1.0 : -1.0) * sign_of(side) * angle;
        const Pose reached = pose_on(TurnCircle{center, radius, side, kNone}, here.heading + turn);
        const PathSegment arc{forwards ? here : reached, radius * angle, sign_of(side) / radius};
        reach(at, arc, reached, side);
        if (!cut_short) break;
      }
    }
  }
  return std::span(attachments).first(lengths.size());
}

std::vector<Attachment> find_maneuvers(const Pose& pose, Direction direction, const Vehicle& vehicle, double radius,
                                       const SweepQuery& sweep, std::size_t max_poses, Spread spread,
                                       const StopClock& clock) {
  ManeuverWorkspace workspace;
  const auto found = find_maneuvers(pose, direction, vehicle, radius, sweep, max_poses, spread, workspace, clock);
  return {found.begin(), found.end()};
}

}  // namespace arcway::internal
