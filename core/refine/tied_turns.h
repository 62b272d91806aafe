#pragma once

#include <cstddef>
#include <span>

#include "core/refine/circle_chain.h"
#include "core/refine/timed_chain.h"

namespace arcway::internal {

/// \file
/// Turns of several arcs to the same side. A circle of a chain is *tied* to a tighter one if the tighter one touches it
/// from within and the path passes from one to the other without a straight. A vehicle that is slow in the tightest
/// part of a turn, or at an end of its path, then speeds up before the turn ends.
///
/// In all functions, `lines` are those of the chain, and circles are given by their index.

/// Whether the circles i and i + 1 touch without a straight between them, the tighter one within the other.
bool are_tied(const CircleChain& chain, std::span<const Bitangent> lines, std::size_t i);

/// Whether circle i is tied to a tighter neighbor. Its center then follows from that neighbor.
bool is_tied(const CircleChain& chain, std::span<const Bitangent> lines, std::size_t i);

/// Replaces circle i. Wider circles tied to it, and those tied to them, keep touching at the same headings, as far as
/// one change can hold them. The first and the last circle stay.
ChainChange shifted(const CircleChain& chain, std::span<const Bitangent> lines, std::size_t i,
                    const TurnCircle& circle);

/// Ties circle i to its tighter neighbor by `turn` [rad] further on, away from it, and with another radius [m].
ChainChange retied(const CircleChain& chain, std::span<const Bitangent> lines, std::size_t i, double turn,
                   double radius);

/// The part of a turn that a circle keeps when another circle takes the rest.
struct KeptTurn {
  std::size_t circle;  ///< index in the chain
  bool leaving;        ///< the rest is driven behind it, not before
  double share;        ///< of the turn, from 0 to 1
};

/// Splits a turn: the circle keeps its part, and the rest is driven on a tied circle `factor` times as wide.
/// Precondition: there is another circle on that side.
ChainChange widened(const CircleChain& chain, std::span<const Bitangent> lines, const KeptTurn& kept, double factor);

/// Puts a circle of another radius [m] between a circle and a wider one that is tied to it on that side. The radius
/// lies between theirs. The circle keeps its part of the turn; the wider one is tied to the new one and turns less.
/// Precondition: the wider circle has neighbors on both sides.
ChainChange stepped(const CircleChain& chain, std::span<const Bitangent> lines, const KeptTurn& kept, double radius);

/// Makes the first or the last circle, i, as tight as allowed [m] for the given turn [rad]. The rest of its turn is
/// driven on a tied circle of another radius [m].
ChainChange pinched(const CircleChain& chain, std::size_t i, double tightest, double turn, double radius);

}  // namespace arcway::internal
