#include "core/refine/tied_turns.h"

#include <algorithm>
#include <initializer_list>

#include "arcway/angle.h"

namespace arcway::internal {

namespace {

constexpr double kTouching = 1e-6;  // distance within which circles touch, in radii of the tighter one

TurnCircle touching(const TurnCircle& tighter, double heading, double radius) {
  return turn_circle(pose_on(tighter, heading), radius, tighter.side);
}

bool is_tied_to_previous(const CircleChain& chain, std::span<const Bitangent> lines, std::size_t i) {
  return i > 0 && chain.circles[i - 1].radius < chain.circles[i].radius && are_tied(chain, lines, i - 1);
}

bool is_tied_to_next(const CircleChain& chain, std::span<const Bitangent> lines, std::size_t i) {
  return i + 1 < chain.circles.size() && chain.circles[i + 1].radius < chain.circles[i].radius &&
         are_tied(chain, lines, i);
}

}  // namespace

bool are_tied(const CircleChain& chain, std::span<const Bitangent> lines, std::size_t i) {
  const TurnCircle& a = chain.circles[i];
  const TurnCircle& b = chain.circles[i + 1];
  return a.side == b.side && a.radius != b.radius && lines[i + 1].length <= kTouching * std::min(a.radius, b.radius);
}

bool is_tied(const CircleChain& chain, std::span<const Bitangent> lines, std::size_t i) {
  return is_tied_to_previous(chain, lines, i) || is_tied_to_next(chain, lines, i);
}

ChainChange shifted(const CircleChain& chain, std::span<const Bitangent> lines, std::size_t i,
                    const TurnCircle& circle) {
  ChainChange change = replaced(chain, i, i + 1, {circle});
  auto& circles = change.circles;
  const auto has_room = [&] { return change.count < circles.size(); };
  for (std::size_t k = i + 1; k + 1 < chain.circles.size() && is_tied_to_previous(chain, lines, k) && has_room(); ++k) {
    circles[change.count] = touching(circles[change.count - 1], lines[k].start.heading, chain.circles[k].radius);
    ++change.count;
    ++change.last;
  }
  for (std::size_t k = i; k-- > 1 && is_tied_to_next(chain, lines, k) && has_room();) {
    const TurnCircle tied = touching(circles[0], lines[k + 1].start.heading, chain.circles[k].radius);
    std::copy_backward(circles.begin(), circles.begin() + static_cast<std::ptrdiff_t>(change.count),
                       circles.begin() + static_cast<std::ptrdiff_t>(change.count) + 1);
    circles[0] = tied;
    ++change.count;
    --change.first;
  }
  return change;
}

ChainChange retied(const CircleChain& chain, std::span<const Bitangent> lines, std::size_t i, double turn,
                   double radius) {
  const bool leaving = is_tied_to_previous(chain, lines, i);
  const TurnCircle& tighter = chain.circles[leaving ? i - 1 : i + 1];
  const double heading = lines[leaving ? i : i + 1].start.heading;
  return shifted(chain, lines, i,
                 touching(tighter, heading + sign_of(tighter.side) * (leaving ? turn : -turn), radius));
}

ChainChange widened(const CircleChain& chain, std::span<const Bitangent> lines, const KeptTurn& kept, double factor) {
  const auto& [i, leaving, share] = kept;
  const TurnCircle& tighter = chain.circles[i];
  const double arrival = lines[i].start.heading;
  const double turn = turn_between(arrival, lines[i + 1].start.heading, tighter.side);
  const double heading = arrival + sign_of(tighter.side) * turn * (leaving ? share : 1.0 - share);
  const TurnCircle wider = touching(tighter, heading, factor * tighter.radius);
  return leaving ? replaced(chain, i, i + 1, {tighter, wider}) : replaced(chain, i, i + 1, {wider, tighter});
}

ChainChange stepped(const CircleChain& chain, std::span<const Bitangent> lines, const KeptTurn& kept, double radius) {
  const auto& [i, leaving, share] = kept;
  const TurnCircle& tighter = chain.circles[i];
  const std::size_t wide = leaving ? i + 1 : i - 1;
  const auto turn_on = [&](std::size_t k) {
    return turn_between(lines[k].start.heading, lines[k + 1].start.heading, chain.circles[k].side);
  };
  const double given = (1.0 - share) * turn_on(i);
  const double taken = std::min(given, 0.5 * turn_on(wide));
  const double forwards = sign_of(tighter.side) * (leaving ? 1.0 : -1.0);
  const double joint = lines[std::max(i, wide)].start.heading;
  const TurnCircle middle = touching(tighter, joint - forwards * given, radius);
  const TurnCircle wider = touching(middle, joint + forwards * taken, chain.circles[wide].radius);
  return leaving ? replaced(chain, i, i + 2, {tighter, middle, wider})
                 : replaced(chain, i - 1, i + 1, {wider, middle, tighter});
}

ChainChange pinched(const CircleChain& chain, std::size_t i, double tightest, double turn, double radius) {
  const bool at_start = i == 0;
  const Side side = chain.circles[i].side;
  const TurnCircle end =
      at_start ? chain.first_circle(chain.lead_in, tightest, side) : chain.last_circle(chain.lead_out, tightest, side);
  const double heading =
      at_start ? chain.start.heading + sign_of(side) * turn : chain.goal.heading - sign_of(side) * turn;
  const TurnCircle tied = touching(end, heading, radius);
  return at_start ? replaced(chain, i, i + 1, {end, tied}) : replaced(chain, i, i + 1, {tied, end});
}

}  // namespace arcway::internal
