// The moves of Refiner that change the turns of a path.

#include <algorithm>
#include <cmath>

#include "arcway/angle.h"
#include "core/refine/refiner.h"
#include "core/refine/tied_turns.h"

namespace arcway::internal {

bool Refiner::take(const DropTurns&) {
  bool any = false;
  for (std::size_t span = circles().size() - 1; span >= 2; --span)
    for (std::size_t i = 0; i + span < circles().size() && !is_over(); ++i)
      any |= accept(replaced(chain_.chain(), i + 1, i + span));
  return any;
}

bool Refiner::take(const RejoinEnds&) {
  bool any = false;
  for (std::size_t keep = 1; keep < circles().size() && !is_over(); ++keep)  // circles from the other end
    for (const bool at_start : {true, false})
      for (const Side side : {Side::kLeft, Side::kRight}) {
        const std::size_t size = circles().size();
        if (keep >= size) break;
        ChainChange change =
            at_start
                ? replaced(chain_.chain(), 0, size - keep, {chain_.chain().first_circle(0.0, smallest_on(side), side)})
                : replaced(chain_.chain(), keep, size, {chain_.chain().last_circle(0.0, smallest_on(side), side)});
        (at_start ? change.lead_in : change.lead_out) = 0.0;
        any |= accept(change);
      }
  return any;
}

bool Refiner::take(const MergeTurns& move) {
  if (move.all) return !done_by_now() && merge(0, circles().size(), move);
  bool any = false;
  for (std::size_t span = circles().size(); span >= 2; --span)
    for (std::size_t i = 0; i + span <= circles().size() && !done_by_now(); ++i) any |= merge(i, i + span, move);
  return any;
}

bool Refiner::merge(std::size_t first, std::size_t last, const MergeTurns& move) {
  const Bitangent before = lines()[first];
  const Bitangent behind = lines()[last];
  const double turn = wrap_signed(behind.start.heading - before.start.heading);
  if (std::abs(turn) < move.least_turn || std::abs(turn) > move.most_turn) return false;
  const Vec2 d = direction_of(before.start.heading);
  const Vec2 e = direction_of(behind.start.heading);
  const Vec2 between = behind.start.position() - before.start.position();
  const double ahead = cross(between, e) / cross(d, e);                 // of the lines' crossing, along `before`
  const double back = behind.length - cross(between, d) / cross(d, e);  // of the far end of `behind` from it
  const double room = std::min(ahead, back);
  const double slope = std::tan(0.5 * std::abs(turn));
  const Side side = turn > 0.0 ? Side::kLeft : Side::kRight;
  for (const double factor : move.radii) {
    const double radius = factor * smallest_on(side);
    if (radius * slope > room) break;
    const Vec2 touch = before.start.position() + (ahead - radius * slope) * d;
    ChainChange change = replaced(chain_.chain(), first, last,
                                  {turn_circle({touch.x(), touch.y(), before.start.heading}, radius, side)});
    if (first == 0) change.lead_in = ahead - radius * slope;
    if (last == circles().size()) change.lead_out = back - radius * slope;
    // A chain has two circles at least: the vehicle does not turn on the goal's one.
    if (move.all) {
      change.circles[change.count++] = chain_.chain().last_circle(0.0, smallest_on(side), side);
      change.lead_out = 0.0;
    }
    if (accept(change)) return true;
  }
  return false;
}

bool Refiner::take(const WidenTurns& move) {
  if (radii_.size() < 2) return false;
  bool any = false;
  for (std::size_t i = 0; i < circles().size() && !is_over(); ++i)
    for (const bool leaving : {true, false}) any |= widen(i, leaving, move);
  any |= pinch(0, move);
  any |= pinch(circles().size() - 1, move);
  return any;
}

bool Refiner::widen(std::size_t i, bool leaving, const WidenTurns& move) {
  const std::size_t other = leaving ? i + 1 : i - 1;
  if (other >= circles().size() || chain_.turn_on(i) < move.least_turn) return false;
  if (are_tied(chain_.chain(), lines(), std::min(i, other))) return step(i, leaving, move);
  for (const double share : move.shares)
    for (const double factor : move.factors)
      if (accept(widened(chain_.chain(), lines(), {i, leaving, share}, factor))) return true;
  return false;
}

bool Refiner::step(std::size_t i, bool leaving, const WidenTurns& move) {
  const std::size_t wide = leaving ? i + 1 : i - 1;
  const double ratio = circles()[wide].radius / circles()[i].radius;
  if (wide == 0 || wide + 1 == circles().size() || ratio < move.least_ratio) return false;
  if (are_tied(chain_.chain(), lines(), leaving ? wide : wide - 1)) return false;
  for (const double share : move.step_shares)
    if (accept(stepped(chain_.chain(), lines(), {i, leaving, share}, std::sqrt(ratio) * circles()[i].radius)))
      return true;
  return false;
}

bool Refiner::pinch(std::size_t i, const WidenTurns& move) {
  const double radius = circles()[i].radius, smallest = smallest_on(circles()[i].side);
  if (radius <= smallest) return false;
  for (const double turn : move.end_turns)
    for (const double factor : move.end_factors)
      if (accept(pinched(chain_.chain(), i, smallest, turn, std::max(factor * radius, move.least_beside * smallest))))
        return true;
  return false;
}

bool Refiner::take(const SlideCircles& move) {
  const double last_step = move.last_step > 0.0 ? move.last_step : options_.smallest_step;
  bool any = false;
  for (double step = move.first_step; step >= last_step && !done(); step *= 0.5) {
    bool moved = true;
    for (int iteration = 0; moved && iteration < move.most_iterations && !done(); ++iteration) {
      moved = false;
      for (std::size_t i = 0; i < circles().size() && !is_over(); ++i) moved |= slide_circle(i, step, move);
      any |= moved;
    }
  }
  return any;
}

bool Refiner::slide_circle(std::size_t i, double step, const SlideCircles& move) {
  if (i == 0 || i + 1 == circles().size()) return slide_end(i, step, move);
  return is_tied(chain_.chain(), lines(), i) ? slide_tied(i, step, move) : slide_middle(i, step, move.steps);
}

bool Refiner::slide_tied(std::size_t i, double step, const SlideCircles& move) {
  bool any = false;
  for (const double turn : {0.0, move.tied_turn * step, -move.tied_turn * step})
    for (const double growth : move.growths) {
      const double grow = growth * step;
      if ((turn == 0.0 && grow == 0.0) || !is_tied(chain_.chain(), lines(), i)) continue;
      any |= accept(retied(chain_.chain(), lines(), i, turn, circles()[i].radius * (1.0 + grow)));
    }
  return any;
}

bool Refiner::slide_end(std::size_t i, double step, const SlideCircles& move) {
  bool any = false;
  for (const double lead : {0.0, step * smallest_, -step * smallest_})
    for (const double growth : move.growths) {
      const CircleChain& chain = chain_.chain();
      const TurnCircle& old = circles()[i];
      const double length = i == 0 ? chain.lead_in : chain.lead_out;
      const double longer = std::max(0.0, length + lead);
      const double larger = std::max(smallest_on(old.side), old.radius * (1.0 + growth * step));
      if (longer == length && larger == old.radius) continue;
      ChainChange change =
          shifted(chain, lines(), i,
                  i == 0 ? chain.first_circle(longer, larger, old.side) : chain.last_circle(longer, larger, old.side));
      (i == 0 ? change.lead_in : change.lead_out) = longer;
      any |= accept(change);
    }
  return any;
}

bool Refiner::slide_middle(std::size_t i, double step, std::span<const CircleStep> steps) {
  bool any = false;
  for (const CircleStep& move : steps) {
    TurnCircle c = circles()[i];
    const Vec2 ahead = direction_of(lines()[i].start.heading + sign_of(c.side) * move.at * chain_.turn_on(i));
    const Vec2 inwards = sign_of(c.side) * perpendicular(ahead);
    const double length = step * smallest_;
    const double larger = std::max(smallest_on(c.side), c.radius * (1.0 + step * move.grow));
    const double inner = swept_annulus(body_, c.side, c.radius).inner;
    const double angle = sign_of(c.side) * move.around * length / std::max(inner, 0.5 * smallest_);
    const Vec2 pivot = c.center - inner * inwards;
    const Vec2 turned = std::cos(angle) * inwards + std::sin(angle) * perpendicular(inwards);
    c.center = pivot + (swept_annulus(body_, c.side, larger).inner + move.inwards * length) * turned +
               move.along * length * ahead;
    c.radius = larger;
    any |= accept(shifted(chain_.chain(), lines(), i, c));
  }
  return any;
}

}  // namespace arcway::internal
