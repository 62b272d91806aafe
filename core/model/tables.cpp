#include "arcway/tables.h"

namespace arcway {

const char* name_of(Table table) {
  switch (table) {
    case Table::kVertices:
      return "vertices";
    case Table::kNext:
      return "next vertices";
    case Table::kCovered:
      return "covered vertices";
    case Table::kRingStarts:
      return "ring starts";
    case Table::kRegionRings:
      return "rings of regions";
    case Table::kRowStarts:
      return "row starts";
    case Table::kTargets:
      return "targets";
    case Table::kRadii:
      return "radii";
    case Table::kIntervalStarts:
      return "interval starts";
    case Table::kIntervals:
      return "heading intervals";
    case Table::kLinkStarts:
      return "link starts";
    case Table::kLinks:
      return "links";
    case Table::kLinkCounts:
      return "link counts";
    case Table::kSelfContacts:
      return "contacts within regions";
  }
  return "?";
}

}  // namespace arcway
