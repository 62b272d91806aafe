#pragma once

#include <cstdint>

namespace arcway {

/// A wish for room: each meter that a vehicle drives close to obstacles costs as much as some seconds. "Close" is where
/// the body, grown by a distance as a safety margin grows it, touches an obstacle or the bounds.
struct ClearancePreference {
  /// Default cost [s/m]. A vehicle at 1 m/s then drives a detour of 100 m rather than 1 m close to an obstacle. It
  /// gives room up where no way around is known, and little else.
  static constexpr double kHighCost = 100.0;
  /// Largest distance [m] and cost [s/m]: no length or time overflows.
  static constexpr double kMost = 1e6;

  double distance;          ///< by which the body is grown [m], > 0
  double cost = kHighCost;  ///< of driving close [s/m], >= 0; 0: measured only, plans are the same as without
  friend bool operator==(const ClearancePreference&, const ClearancePreference&) = default;
};

/// What a plan drives closer to obstacles than preferred.
struct CloseDriving {
  double distance = 0.0;  ///< preferred [m]
  double length = 0.0;    ///< of F's path where the grown body touches an obstacle or the bounds [m]
  double cost = 0.0;      ///< of that [s]
};

/// What a plan drives in a clearance zone closer to obstacles than the zone asks for.
struct ZoneCloseDriving {
  std::uint32_t zone;  ///< index among World::zones
  CloseDriving close;
};

}  // namespace arcway
