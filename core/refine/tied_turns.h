#pragma once

#include <cstddef>
#include <span>

#include "core/refine/circle_chain.h"
#include "core/refine/timed_chain.h"

namespace arcway::internal {

/// \file
/// Turns in several arcs to the same side: a circle of a chain may be tied to a tighter one that touches it from
/// within, where the path goes from one to the other without a straight. A vehicle that is slow in the tightest part of
/// a turn, or at an end of its path, so gets faster before the turn ends.
///
/// `lines` are those of the chain; circles are told by their place in it.

/// Whether the circles i and i + 1 touch without a straight between them, the tighter one within the other.
bool are_tied(const CircleChain& chain, std::span<const Bitangent> lines, std::size_t i);

/// Whether circle i is tied to a tighter neighbor: it has no place of its own.
bool is_tied(const CircleChain& chain, std::span<const Bitangent> lines, std::size_t i);

/// Circle i becomes another one. Wider ones that are tied to it, and those tied to them, touch at the same headings as
/// before, as far as a change holds them; the first and the last circle stay.
ChainChange shifted(const CircleChain& chain, std::span<const Bitangent> lines, std::size_t i,
                    const TurnCircle& circle);

/// Circle i, which is tied to a tighter one, touches that `turn` further on, away from it, and has another radius.
ChainChange retied(const CircleChain& chain, std::span<const Bitangent> lines, std::size_t i, double turn,
                   double radius);

/// Circle i keeps a share of its turn only, the rest is driven on one `factor` times as wide that is tied to it: before
/// it or, `leaving`, behind it. Precondition: there is another circle on that side.
ChainChange widened(const CircleChain& chain, std::span<const Bitangent> lines, std::size_t i, bool leaving,
                    double share, double factor);

/// A wider circle is tied to circle i behind it or, not `leaving`, before it. Circle i keeps a share of its turn only,
/// and a circle of a radius between theirs comes between the two, tied to it. The wider one is tied to that, and turns
/// less. Precondition: the wider one has neighbors on both sides.
ChainChange stepped(const CircleChain& chain, std::span<const Bitangent> lines, std::size_t i, bool leaving,
                    double share, double radius);

/// The first or the last circle, i, becomes as tight as can be, for the given turn; the rest of its turn is driven on a
/// circle of another radius that is tied to it.
ChainChange pinched(const CircleChain& chain, std::size_t i, double tightest, double turn, double radius);

}  // namespace arcway::internal
