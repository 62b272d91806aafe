#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "arcway/export.h"
#include "arcway/vec2.h"
#include "arcway/zone.h"

namespace arcway {

/// The arrays of the snapshots of worlds and graphs, for files and error messages. Prepared files store the numbers.
enum class SnapshotArray : std::uint32_t {
  kVertices = 1,
  kNext,
  kCovered,
  kRingStarts,
  kRegionRings,
  kRowStarts,
  kTargets,
  kRadii,
  kIntervalStarts,
  kIntervals,
  kLinkStarts,
  kLinks,
  kLinkCounts,
  kSelfContacts,
  kKeepOuts
};
/// The array in words: "vertices", "row starts", ...
ARCWAY_API const char* name_of(SnapshotArray array);

/// Thrown for an entry of a snapshot that no world or graph can have.
class ARCWAY_API SnapshotError : public std::invalid_argument {
 public:
  SnapshotError(SnapshotArray array, std::size_t index, const std::string& message)
      : std::invalid_argument(std::string(name_of(array)) + ", entry " + std::to_string(index) + ": " + message),
        array_(array),
        index_(index) {}
  [[nodiscard]] SnapshotArray array() const { return array_; }
  [[nodiscard]] std::size_t index() const { return index_; }

 private:
  SnapshotArray array_;
  std::size_t index_;
};

/// A vertex inside an edge of its own region, with the vertex's ring on the edge's left: see World::self_contacts.
struct SelfContact {
  std::uint32_t edge, vertex;
  friend bool operator==(const SelfContact&, const SelfContact&) = default;
};

/// A world as flat arrays, see World::snapshot and World::from_snapshot.
struct WorldSnapshot {
  std::vector<Vec2> vertices;               ///< World::vertices [m]
  std::vector<std::uint32_t> next;          ///< by vertex: World::next
  std::vector<std::uint8_t> covered;        ///< by vertex: World::is_covered, 0 or 1
  std::vector<std::uint32_t> ring_starts;   ///< first vertex of each ring, ascending
  std::vector<std::uint32_t> region_rings;  ///< first ring of each region, ascending; then the number of rings
  std::vector<SelfContact> self_contacts;   ///< World::self_contacts
  bool has_bounds = false;                  ///< whether the last region is the bounds
  std::vector<Zone> zones = {};             ///< World::zones
  /// By zone: the obstacle that stands for it, kNone if there is none. Empty if no zone has one.
  std::vector<std::uint32_t> keep_outs = {};
};

}  // namespace arcway
