#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <vector>

#include "arcway/vehicle.h"
#include "core/motion/speed_profile.h"
#include "core/motion/speed_tree.h"
#include "core/refine/circle_chain.h"

namespace arcway::internal {

/// A change of a chain: some neighboring circles give way to others, a few at most.
struct ChainChange {
  std::size_t first, last;  ///< circles [first, last) go, and
  std::size_t count;        ///< so many of these come
  std::array<TurnCircle, 6> circles;
  double lead_in, lead_out;  ///< of the changed chain

  [[nodiscard]] std::size_t size_after(std::size_t circles_before) const {
    return circles_before - (last - first) + count;
  }
};

/// The circles [first, last) of a chain replaced by others, its ends as they are.
ChainChange replaced(const CircleChain& chain, std::size_t first, std::size_t last,
                     std::initializer_list<TurnCircle> by = {});

/// A chain with its lines, its path and the path's speeds, and what becomes of them by a change.
class TimedChain {
 public:
  /// Takes a chain; false if two of its neighbors have no bitangent. The vehicle must outlive the use.
  bool begin(const CircleChain& chain, const Vehicle& vehicle);

  [[nodiscard]] const CircleChain& chain() const { return now_.chain; }
  /// One more than circles: see `lines_of`.
  [[nodiscard]] const std::vector<Bitangent>& lines() const { return now_.lines; }
  /// On the circle between lines()[circle] and the next one [rad].
  [[nodiscard]] double turn_on(std::size_t circle) const;

  struct Passing {
    double time;
    double speed;
  };
  /// When, and how fast, the path gets to the beginning of a line, and to its end.
  [[nodiscard]] const Passing& begin_of(std::size_t line) const { return passings_[2 * line]; }
  [[nodiscard]] const Passing& end_of(std::size_t line) const { return passings_[2 * line + 1]; }

  /// A line of a changed path, or an arc on a circle of it.
  struct Part {
    double length;
    double limit;       ///< of the speed [m/s]
    Bitangent line;     ///< only the heading of its start, for an arc
    TurnCircle circle;  ///< of an arc
    bool is_arc;
    [[nodiscard]] PathSegment segment() const;
  };
  /// Finds out what a change leads along, from the line before it to the line behind it: all that the path before and
  /// after it do not have in common. Nothing of zero length. False if two neighbors have no bitangent.
  bool lay_out(const ChainChange& change);
  [[nodiscard]] const std::vector<Part>& laid_out() const { return laid_out_; }
  /// The travel time after the change that was laid out last, from its parts alone: up to rounding, or less.
  [[nodiscard]] double time_after(const ChainChange& change);

  /// Makes the changed path; false if two neighbors have no bitangent.
  bool make(const ChainChange& change);
  [[nodiscard]] const Path& made_path() const { return made_.path; }
  [[nodiscard]] double made_time() const { return made_.profile.total_time; }
  /// Keeps what was made last.
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
  State now_, made_;
  // Lines and circles by turns: line i is 2 i, circle i is 2 i + 1.
  std::vector<Stretch> stretches_;
  std::vector<Passing> passings_;  // of their beginnings, and of the end
  // Joints at the beginning of each, from the start, and at its end, from the goal backwards.
  SpeedTree from_start_, from_goal_;
  std::vector<std::uint32_t> start_joints_, goal_joints_;
  std::vector<Part> laid_out_;
};

}  // namespace arcway::internal
