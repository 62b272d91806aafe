#include "core/attach/maneuvers.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "arcway/angle.h"
#include "core/base/open_list.h"

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
  // Adds a cell. False if the set has it.
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

struct ManeuverSearch::Memory {
  std::vector<Attachment> attachments;  // those of before have memory for connections
  std::vector<double> lengths;          // of the connections found now
  OpenList<Waiting> open;
  CellSet seen;
  HeadingSet headings;
};

// One search.
class ManeuverSearch::Run {
 public:
  Run(Direction direction, const ManeuveringBody& body, Spread spread, Memory& memory)
      : forwards_(direction == Direction::kFromStart),
        body_(body),
        step_(body.radii.smaller() * kStepTurn),
        grid_(spread == Spread::kDense ? Grid{0.5 * step_, 128} : Grid{0.5 * body.radii.smaller(), 32}),
        m_(memory) {}

  std::span<const Attachment> find(const Pose& pose, std::size_t most, const StopClock& clock) {
    m_.lengths.clear();
    m_.open.clear();
    m_.seen.begin(most + kStepsFromAPose);
    add(pose, 0.0);
    m_.seen.insert(cell_of(pose, grid_));
    while (!m_.open.empty() && m_.lengths.size() < most && !clock.is_over()) {
      const std::size_t at = m_.open.pop().pose;
      drive_straight(at);
      for (const Side side : {Side::kLeft, Side::kRight}) turn(at, side);
    }
    return std::span(m_.attachments).first(m_.lengths.size());
  }

 private:
  Attachment& add(const Pose& reached, double length) {
    if (m_.attachments.size() == m_.lengths.size()) m_.attachments.emplace_back();
    Attachment& attachment = m_.attachments[m_.lengths.size()];
    attachment.pose = reached;
    attachment.connection.clear();
    attachment.shared.reset();
    m_.open.push({length, m_.lengths.size()});
    m_.lengths.push_back(length);
    return attachment;
  }

  // Adds the pose at the other end of a step unless one in its cell is known.
  void reach(std::size_t from, const PathSegment& segment, const Pose& reached, std::optional<Side> turned = {}) {
    if (!m_.seen.insert(cell_of(reached, grid_))) return;
    Attachment& attachment = add(reached, m_.lengths[from] + segment.length);
    attachment.shared = turned;
    Path& connection = attachment.connection;
    const Path& before = m_.attachments[from].connection;
    if (!forwards_) connection.push_back(segment);
    connection.insert(connection.end(), before.begin(), before.end());
    if (forwards_) connection.push_back(segment);
  }

  void drive_straight(std::size_t at) {
    const Pose here = m_.attachments[at].pose;
    const Vec2 ahead = direction_of(here.heading);
    for (const double steps : kLineSteps) {
      const double length = steps * step_;
      const Vec2 other = here.position() + (forwards_ ? length : -length) * ahead;
      const Pose reached{other.x(), other.y(), here.heading};
      const PathSegment line{forwards_ ? here : reached, length, 0.0};
      if (!body_.sweep.straight_free({line.start, length, body_.body})) break;
      reach(at, line, reached);
    }
  }

  void turn(std::size_t at, Side side) {
    const double radius = body_.radii.of(side);
    const Pose here = m_.attachments[at].pose;
    const Vec2 center = here.position() + sign_of(side) * radius * perpendicular(direction_of(here.heading));
    const TurningBody turning{center, radius, side, body_.body};
    const Side towards = forwards_ ? side : opposite(side);
    const double room = body_.sweep.reach(turning, here.heading, towards, m_.headings);
    // If an obstacle ends the turn early, free motions may leave from a narrow range of headings before its end.
    const bool cut_short = room < kStepTurn;
    for (const double share : kShares) {
      const double angle = cut_short ? share * room : kStepTurn;
      if (angle < kLeastTurn) break;
      const double turned = (forwards_ ? 1.0 : -1.0) * sign_of(side) * angle;
      const Pose reached = pose_on(TurnCircle{center, radius, side, kNone}, here.heading + turned);
      const PathSegment arc{forwards_ ? here : reached, radius * angle, sign_of(side) / radius};
      reach(at, arc, reached, side);
      if (!cut_short) break;
    }
  }

  bool forwards_;
  const ManeuveringBody& body_;
  double step_;  // [m]
  Grid grid_;
  Memory& m_;
};

ManeuverSearch::ManeuverSearch() : memory_(std::make_unique<Memory>()) {}
ManeuverSearch::~ManeuverSearch() = default;
ManeuverSearch::ManeuverSearch(ManeuverSearch&&) noexcept = default;
ManeuverSearch& ManeuverSearch::operator=(ManeuverSearch&&) noexcept = default;

std::span<const Attachment> ManeuverSearch::find(const Pose& pose, Direction direction, const ManeuveringBody& body,
                                                 const ManeuverPoses& poses, const StopClock& clock) {
  return Run(direction, body, poses.spread, *memory_).find(pose, poses.most, clock);
}

}  // namespace arcway::internal
