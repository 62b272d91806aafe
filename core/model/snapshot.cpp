#include "arcway/snapshot.h"

namespace arcway {

const char* name_of(SnapshotArray array) {
  switch (array) {
    case SnapshotArray::kVertices:
      return "vertices";
    case SnapshotArray::kNext:
      return "next vertices";
    case SnapshotArray::kCovered:
      return "covered vertices";
    case SnapshotArray::kRingStarts:
      return "ring starts";
    case SnapshotArray::kRegionRings:
      return "rings of regions";
    case SnapshotArray::kRowStarts:
      return "row starts";
    case SnapshotArray::kTargets:
      return "targets";
    case SnapshotArray::kRadii:
      return "radii";
    case SnapshotArray::kIntervalStarts:
      return "interval starts";
    case SnapshotArray::kIntervals:
      return "heading intervals";
    case SnapshotArray::kLinkStarts:
      return "link starts";
    case SnapshotArray::kLinks:
      return "links";
    case SnapshotArray::kLinkCounts:
      return "link counts";
    case SnapshotArray::kSelfContacts:
      return "contacts within regions";
    case SnapshotArray::kKeepOuts:
      return "obstacles of keep-outs";
  }
  return "?";
}

}  // namespace arcway
