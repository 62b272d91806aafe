#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/collision/motion_free.h"
#include "core/model/side_radii.h"
#include "core/motion/speed_profile.h"
#include "core/refine/circle_chain.h"
#include "core/refine/moves.h"
#include "core/refine/optimize_chain.h"
#include "core/refine/refine_path.h"
#include "core/refine/timed_chain.h"

namespace arcway::internal {

/// A place on a straight line of the path.
struct Station {
  std::size_t line;
  double part;  ///< of the line's length
  Pose pose;
  Vec2 left;
  double time;   ///< when the path gets there, approximate between the ends of a line [s]
  double speed;  ///< upper bound there [m/s]
};

struct PathRefiner::Memory {
  CircleChain first_chain;
  TimedChain chain;
  std::vector<double> radii;
  std::vector<Station> stations;
  HeadingSet headings;
  SpeedProfile profile;
  ChainOptimizer optimizer;
  CircleChain optimized;
  Path optimized_path;
};

/// One refinement by PathRefiner. When which move is tried, and which change is accepted, is in refiner.cpp; the
/// changes that moves propose are in turn_moves.cpp and word_moves.cpp.
class Refiner {
 public:
  Refiner(const RefineQuery& query, PathRefiner::Memory& memory, RefinedPath& result);

  void run(CircleChain& chain);

 private:
  // Optimizes all turns, once it is roughly known which they are. Returns whether that ends refinement.
  bool optimize();
  bool optimize_at_length();
  // Where turns are slower than lines however wide they are, leaving one out is a jump.
  [[nodiscard]] bool may_leave_optimum() const;
  // Tries the moves that change the order of turns, and optimizes again where they help.
  void leave_optimum();
  void simplify();
  // Leads to a local optimum of the moves.
  void settle();

  // Tries the moves of a stage, one by one until one helps. Returns whether one did.
  bool take_first(Stage stage);
  // Tries all moves of a stage. Returns whether one helped.
  bool take_all(Stage stage);
  bool take(const MoveRow& row);

  // Whether refinement is over, with a question to the clock.
  [[nodiscard]] bool done();
  // Without one. It serves loops whose trials ask the clock.
  [[nodiscard]] bool is_over() const;
  // With one in some calls. It serves loops that try next to nothing.
  [[nodiscard]] bool done_by_now();

  [[nodiscard]] const std::vector<TurnCircle>& circles() const { return chain_.chain().circles; }
  [[nodiscard]] const std::vector<Bitangent>& lines() const { return chain_.lines(); }
  [[nodiscard]] double smallest_on(Side side) const { return smallest_radii_.of(side); }

  // Takes a change if it makes the path cheaper and the path stays free.
  bool accept(const ChainChange& change);
  // A turn that falls short of a full circle by next to nothing counts as none, see turn_between. Such a path misses a
  // goal closely behind the start, and is faster than any path can be.
  [[nodiscard]] bool is_made_cheaper() const;
  void take_made();
  // Whether the parts that the current path does not have are free, cheapest questions first. Parts are those of a
  // changed chain, or the segments of a path.
  template <class Parts>
  bool are_free(const Parts& parts);
  [[nodiscard]] bool is_known(const PathSegment& s) const;
  bool straight_free(const Pose& from, double length);
  bool is_free(const PathSegment& arc);

  bool take(const OptimizeTurns& move);
  // Returns whether there is an optimized chain.
  bool propose(const OptimizeTurns& move);
  // A radius is known by its curvature alone, and may come out too small by rounding.
  void widen_rounded(CircleChain& chain) const;

  bool take(const DropTurns& move);
  bool take(const RejoinEnds& move);
  bool take(const MergeTurns& move);
  // Replaces the circles [first, last) by one circle, tangent to the lines before and behind them.
  bool merge(std::size_t first, std::size_t last, const MergeTurns& move);
  // Makes parts of turns wider, where wider turns are faster.
  bool take(const WidenTurns& move);
  bool widen(std::size_t i, bool leaving, const WidenTurns& move);
  // Puts a turn of a radius between those of a tight turn and of a wider one beside it.
  bool step(std::size_t i, bool leaving, const WidenTurns& move);
  // Makes the turn at an end of the path tight: the vehicle is slow there, so that this costs little.
  bool pinch(std::size_t i, const WidenTurns& move);
  bool take(const SlideCircles& move);
  bool slide_circle(std::size_t i, double step, const SlideCircles& move);
  bool slide_tied(std::size_t i, double step, const SlideCircles& move);
  bool slide_end(std::size_t i, double step, const SlideCircles& move);
  bool slide_middle(std::size_t i, double step, std::span<const CircleStep> steps);

  // Words lead from places on one line to places on another.
  bool take(const InsertWords& move);
  void find_stations(const InsertWords& move);
  [[nodiscard]] Station station(std::size_t line, double part) const;
  // Least time for a length between two speeds.
  [[nodiscard]] double time_between(double length, double v1, double v3) const;
  // Length and time of two turns.
  [[nodiscard]] std::pair<double, double> turns_of(double r0, double turn0, double r1, double turn1) const;
  bool insert_word(const Station& from, const Station& to);

  static constexpr double kTimeSlack = 1e-9;  // share of a travel time, far above its rounding

  const RefineQuery& query_;
  const Vehicle& vehicle_;
  const SweepQuery& sweep_;
  const RefineOptions& options_;
  const StopClock& clock_;
  RefinedPath& result_;
  Body body_;
  SideRadii smallest_radii_;
  double smallest_;          // the smaller one of these [m]
  double cost_;              // of the path: its travel time, plus that of driving close to obstacles [s]
  double least_time_ = 0.0;  // lower bound of the time of all paths [s]
  double least_cost_ = 0.0;  // lower bound of their cost [s]
  std::uint32_t iterations_ = 0;
  TimedChain& chain_;
  std::vector<double>& radii_;
  std::vector<Station>& stations_;
  HeadingSet& headings_;
  ChainOptimizer& optimizer_;
  CircleChain& optimized_;
  Path& optimized_path_;
  std::uint64_t most_trials_;
};

}  // namespace arcway::internal
