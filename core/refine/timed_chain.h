#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <vector>

#include "arcway/vehicle.h"
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
  /// Takes a chain. The vehicle and the zones must outlive the use.
  /// @param ends  speeds of its path and those of all changed ones.
  /// @param zones  whose limits hold; may be null.
  /// @return false if two neighbors have no bitangent, or no motion has these end speeds.
  bool begin(const CircleChain& chain, const Vehicle& vehicle, const EndSpeeds& ends = {},
             const SpeedZones* zones = nullptr);

  [[nodiscard]] const CircleChain& chain() const { return now_.chain; }
  /// See lines_of.
  [[nodiscard]] const std::vector<Bitangent>& lines() const { return now_.lines; }
  /// The turn on the circle between lines()[circle] and the next line [rad].
  [[nodiscard]] double turn_on(std::size_t circle) const;

  struct Passing {
    double time;
    double speed;
  };
  /// When the path passes the beginning of a line, or its end [s], and how fast [m/s].
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
  /// @return false if two neighbors have no bitangent.
  bool lay_out(const ChainChange& change);
  [[nodiscard]] const std::vector<Part>& laid_out() const { return laid_out_; }
  /// The travel time after the change laid out last [s], from its parts alone: exact up to rounding, or too small. It
  /// knows no zones. Infinity if no motion has the end speeds.
  [[nodiscard]] double time_after(const ChainChange& change);

  /// Makes the changed path.
  /// @return false if two neighbors have no bitangent, or no motion has the end speeds.
  bool make(const ChainChange& change);
  /// Makes the path of another chain.
  /// @return false as `make` of a change.
  bool make(const CircleChain& chain);
  [[nodiscard]] const Path& made_path() const { return made_.path; }
  [[nodiscard]] double made_time() const { return made_.profile.total_time; }
  /// Makes the path made last the current one.
  void take();

 private:
  struct State {
    CircleChain chain;
    std::vector<Bitangent> lines;
    Path path;
    SpeedProfile profile;
  };
  struct Stretch {
    double length;
    double limit;
  };

  bool complete(State& state) const;
  void time_parts();
  void add_line(const Bitangent& line);
  void add_arc(const TurnCircle& circle, double from, double to);

  const Vehicle* vehicle_ = nullptr;
  EndSpeeds ends_;
  const SpeedZones* zones_ = nullptr;
  State now_, made_;
  // Lines and circles alternate: line i has index 2 i, circle i has 2 i + 1.
  std::vector<Stretch> stretches_;
  std::vector<Passing> passings_;  // of the beginnings of lines and circles, and of the end of the path
  // Joints at the beginning of each line or circle, from the start, and at its end, backwards from the goal.
  SpeedTree from_start_, from_goal_;
  std::vector<std::uint32_t> start_joints_, goal_joints_;
  std::vector<Part> laid_out_;
};

}  // namespace arcway::internal
