#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <vector>

#include "arcway/vehicle.h"
#include "core/collision/clearance_cost.h"
#include "core/motion/speed_profile.h"
#include "core/motion/speed_tree.h"
#include "core/refine/circle_chain.h"
#include "core/zones/speed_zones.h"

namespace arcway::internal {

/// A change of a chain: a few neighboring circles are replaced by others.
struct ChainChange {
  std::size_t first, last;  ///< circles [first, last) are removed, and
  std::size_t count;        ///< this many of `circles` take their place
  std::array<TurnCircle, 6> circles;
  double lead_in, lead_out;  ///< of the changed chain

  [[nodiscard]] std::size_t size_after(std::size_t circles_before) const {
    return circles_before - (last - first) + count;
  }
};

/// Replaces the circles [first, last) of a chain by others; its straights at the ends stay.
ChainChange replaced(const CircleChain& chain, std::size_t first, std::size_t last,
                     std::initializer_list<TurnCircle> by = {});

/// A chain with its lines, its path and the path's speeds, and what a change makes of them.
class TimedChain {
 public:
  /// Takes a chain. The vehicle, the zones and the clearance's cost must outlive the use.
  /// @param ends  speeds of its path and those of all changed ones.
  /// @param zones  whose limits hold; may be null.
  /// @param clearance  what driving close to obstacles costs; may be null.
  /// @return false if two neighbors have no bitangent, or no motion has these end speeds.
  bool begin(const CircleChain& chain, const Vehicle& vehicle, const EndSpeeds& ends = {},
             const SpeedZones* zones = nullptr, const ClearanceCost* clearance = nullptr);

  [[nodiscard]] const CircleChain& chain() const { return now_.chain; }
  /// See lines_of.
  [[nodiscard]] const std::vector<Bitangent>& lines() const { return now_.lines; }
  /// The turn on the circle between lines()[circle] and the next line [rad].
  [[nodiscard]] double turn_on(std::size_t circle) const;

  struct Passing {
    double time;
    double speed;
    double clearance_cost;
  };
  /// When the path passes the beginning of a line, or its end [s], how fast [m/s], and what driving close to obstacles
  /// has cost by then [s].
  [[nodiscard]] const Passing& begin_of(std::size_t line) const { return passings_[2 * line]; }
  [[nodiscard]] const Passing& end_of(std::size_t line) const { return passings_[2 * line + 1]; }

  /// A line of a changed path, or an arc on one of its circles.
  struct Part {
    double length;
    double limit;       ///< of the speed [m/s]
    Bitangent line;     ///< of an arc: only the heading of its start
    TurnCircle circle;  ///< of an arc
    bool is_arc;
    [[nodiscard]] PathSegment segment() const;
  };
  /// Computes the part of the path that a change affects, from the line before it to the line behind it, without parts
  /// of zero length.
  /// @return false if two neighbors have no bitangent, or no circle is left.
  bool lay_out(const ChainChange& change);
  [[nodiscard]] const std::vector<Part>& laid_out() const { return laid_out_; }
  /// The cost after the change laid out last [s], from its parts alone: exact up to rounding, or too small. Infinity if
  /// no motion has the end speeds.
  /// @param enough  what costs at least this need not be known better [s].
  [[nodiscard]] double cost_after(const ChainChange& change, double enough);

  /// Makes the changed path.
  /// @return false if two neighbors have no bitangent, or no motion has the end speeds.
  bool make(const ChainChange& change);
  /// Makes the path of another chain.
  /// @return false as `make` of a change.
  bool make(const CircleChain& chain);
  [[nodiscard]] const Path& made_path() const { return made_.path; }
  [[nodiscard]] double made_time() const { return made_.profile.total_time; }
  /// Its travel time, plus the cost of driving close to obstacles [s].
  [[nodiscard]] double made_cost() const { return made_.profile.total_time + made_.clearance_cost; }
  /// Makes the path made last the current one.
  void take();

 private:
  struct State {
    CircleChain chain;
    std::vector<Bitangent> lines;
    Path path;
    SpeedProfile profile;
    double clearance_cost = 0.0;  // [s]
  };
  struct Stretch {
    double length;
    double limit;
    double clearance_cost = 0.0;  // [s]
  };

  // Of a stretch or a part, between two borders of zones.
  struct Piece {
    double length;
    double limit;
  };

  bool complete(State& state) const;
  void time_parts();
  void cut_stretches();
  void append_pieces(const PathSegment& segment, double limit, std::vector<Piece>& pieces);
  [[nodiscard]] double time_after(const ChainChange& change, double enough);
  // The stretches that a change laid out last leaves as they are end before `first`, and begin behind `last`.
  struct Affected {
    std::size_t first, last;
  };
  [[nodiscard]] Affected affected_by(const ChainChange& change) const;
  // The time of the path whose affected stretches are replaced by others.
  template <class Pieces>
  [[nodiscard]] double time_through(const Affected& affected, const Pieces& pieces);
  void add_line(const Bitangent& line);
  void add_arc(const TurnCircle& circle, double from, double to);

  const Vehicle* vehicle_ = nullptr;
  EndSpeeds ends_;
  const SpeedZones* zones_ = nullptr;
  const ClearanceCost* clearance_ = nullptr;
  State now_, made_;
  // Lines and circles alternate: line i has index 2 i, circle i has 2 i + 1.
  std::vector<Stretch> stretches_;
  std::vector<Piece> pieces_;             // of the stretches, one after the other
  std::vector<std::size_t> first_piece_;  // by stretch; then their number
  std::vector<Passing> passings_;         // of the beginnings of lines and circles, and of the end of the path
  // Joints at the beginning of each line or circle, from the start, and at its end, backwards from the goal.
  SpeedTree from_start_, from_goal_;
  std::vector<std::uint32_t> start_joints_, goal_joints_;
  std::vector<Part> laid_out_;
  std::vector<Piece> changed_;            // of the parts laid out
  std::vector<SpeedZones::Stretch> cut_;  // of one segment
};

}  // namespace arcway::internal
