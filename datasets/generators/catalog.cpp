#include "arcway/datasets/catalog.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <utility>

#include "arcway/datasets/adversarial_world.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/curved_world.h"
#include "arcway/datasets/driven_world.h"
#include "arcway/datasets/paper_example.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/datasets/structured_world.h"
#include "datasets/io/nearest_word.h"
#include "datasets/io/shortened.h"

namespace arcway {

using namespace internal;
namespace {

[[noreturn]] void refuse(std::string_view name, const std::string& message) {
  throw std::invalid_argument("catalog world \"" + shortened(name) + "\": " + message);
}

std::string_view first_part(std::string_view name) { return name.substr(0, name.find('/')); }

class Parts;
struct Entry {
  CatalogFamily family;
  MapFile (*make)(const Parts&);
};
const std::vector<Entry>& entries();

const Entry* find_entry(std::string_view name) {
  const auto named = [&](const Entry& entry) { return entry.family.name == first_part(name); };
  const auto found = std::ranges::find_if(entries(), named);
  return found == entries().end() ? nullptr : &*found;
}

// A name taken apart: the index of its kind, and the numbers behind its letters.
class Parts {
 public:
  explicit Parts(std::string_view name) : name_(name), entry_(find_entry(name)) {
    if (entry_ == nullptr) {
      std::vector<std::string_view> names;
      for (const CatalogFamily& family : catalog_families()) names.push_back(family.name);
      refuse(name, unknown_word("family", first_part(name), names));
    }
    const CatalogFamily& family = entry_->family;
    std::string_view rest = name.substr(family.name.size());
    const auto next = [&rest] {
      rest.remove_prefix(1);
      const std::string_view part = first_part(rest);
      rest.remove_prefix(part.size());
      return part;
    };
    if (!family.kinds.empty()) {
      const std::string_view kind = rest.empty() ? "" : next();
      const auto found = std::ranges::find(family.kinds, kind);
      if (found == family.kinds.end()) refuse(name, unknown_word("kind", kind, family.kinds));
      kind_ = static_cast<std::size_t>(found - family.kinds.begin());
    }
    while (!rest.empty()) add(next());
  }

  [[nodiscard]] std::string_view name() const { return name_; }
  [[nodiscard]] const Entry& entry() const { return *entry_; }
  [[nodiscard]] std::size_t kind() const { return kind_; }
  [[nodiscard]] std::uint64_t number(char letter, std::uint64_t missing) const {
    for (const auto& [key, value] : numbers_)
      if (key == letter) return value;
    return missing;
  }

 private:
  void add(std::string_view part) {
    std::uint64_t value = 0;
    const char* begin = part.data() + std::min<std::size_t>(part.size(), 1);
    const char* end = part.data() + part.size();
    const auto [stop, error] = std::from_chars(begin, end, value);
    // The letters of a family are those of its pattern that stand behind a slash.
    const std::string_view pattern = entry_->family.pattern;
    const bool known = !part.empty() && part[0] >= 'a' && part[0] <= 'z' &&
                       pattern.find("/" + std::string(1, part[0])) != std::string_view::npos;
    if (!known || begin == end || stop != end || error != std::errc())
      refuse(name_, "unexpected part \"" + shortened(part) + "\"; expected " + std::string(pattern));
    for (const auto& [letter, number] : numbers_)
      if (letter == part[0]) refuse(name_, "second part \"" + shortened(part) + "\" of one letter");
    numbers_.emplace_back(part[0], value);
  }

  std::string_view name_;
  const Entry* entry_;
  std::size_t kind_ = 0;
  std::vector<std::pair<char, std::uint64_t>> numbers_;
};

MapFile clutter_map(const Parts& parts) {
  constexpr std::array kKinds{ClutterKind::kConvex, ClutterKind::kStar, ClutterKind::kMixed, ClutterKind::kRectangle};
  const ClutterParameters defaults;
  Clutter clutter = generate_clutter({.kind = kKinds[parts.kind()],
                                      .obstacles = parts.number('n', defaults.obstacles),
                                      .vertices = parts.number('m', defaults.vertices),
                                      .fill = static_cast<double>(parts.number('f', 20)) / 100.0,
                                      .seed = parts.number('s', defaults.seed)});
  MapFile map;
  map.obstacles = std::move(clutter.obstacles);
  map.bounds = std::move(clutter.bounds);
  return map;
}

template <StructuredKind kind>
MapFile structured_map(const Parts& parts) {
  const StructuredParameters defaults;
  return generate_structured_world(
      {.kind = kind, .vertices = parts.number('v', defaults.vertices), .seed = parts.number('s', defaults.seed)});
}

MapFile adversarial_map(const Parts& parts) {
  const AdversarialParameters defaults;
  return generate_adversarial_world({.kind = kAdversarialKinds[parts.kind()],
                                     .vertices = parts.number('v', defaults.vertices),
                                     .seed = parts.number('s', defaults.seed)});
}

MapFile ponds_map(const Parts& parts) {
  const CurvedWorldParameters defaults;
  const std::uint64_t tolerance = parts.number('t', 10);
  if (tolerance == 0) refuse(parts.name(), "a tolerance of 0 mm, must be at least 1");
  const CurvedWorld world =
      generate_curved_world({.curves = parts.number('n', defaults.curves), .seed = parts.number('s', defaults.seed)});
  MapFile map;
  for (const CurvedRing& curve : world.curves)
    map.obstacles.push_back({circumscribed_ring(curve.pieces, 1e-3 * static_cast<double>(tolerance)), {}});
  map.bounds = world.bounds;
  const Vec2& corner = (*world.bounds)[2];
  map.start = Pose{7.0, 7.0, 0.0};
  map.goal = Pose{corner.x() - 7.0, corner.y() - 7.0, 0.0};
  return map;
}

DrivenWorld driven_world(const Parts& parts) {
  const DrivenParameters defaults;
  const std::uint64_t gears = parts.number('g', 1);
  if (gears != 1 && gears != 2) refuse(parts.name(), std::to_string(gears) + " gears, must be 1 or 2");
  return generate_driven_world({.kind = kDrivenKinds[parts.kind()],
                                .robot = parts.number('r', defaults.robot),
                                .both_gears = gears == 2,
                                .clearance = 1e-3 * static_cast<double>(parts.number('c', 50)),
                                .seed = parts.number('s', defaults.seed)});
}

MapFile driven_map(const Parts& parts) { return driven_world(parts).map; }

MapFile paper_map(const Parts&) {
  PaperExample example = paper_example();
  MapFile map = to_map_file(example.world);
  map.start = example.start;
  map.goal = example.goal;
  return map;
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = {
      {{"paper", {}, "paper", "the paper's example, with start and goal"}, paper_map},
      {{"clutter",
        {"convex", "star", "mixed", "rectangle"},
        "clutter/KIND/nOBSTACLES/mVERTICES_OF_EACH/fFILL_PERCENT/sSEED",
        "disjoint random obstacles in a square"},
       clutter_map},
      {{"warehouse", {}, "warehouse/vVERTICES/sSEED", "racks, aisles and pallets"},
       structured_map<StructuredKind::kWarehouse>},
      {{"parking", {}, "parking/vVERTICES/sSEED", "rows of parked cars, the goal a free bay"},
       structured_map<StructuredKind::kParking>},
      {{"rooms", {}, "rooms/vVERTICES/sSEED", "rooms with doors and tables"}, structured_map<StructuredKind::kRooms>},
      {{"maze", {}, "maze/vVERTICES/sSEED", "a maze with loops"}, structured_map<StructuredKind::kMaze>},
      {{"city", {}, "city/vVERTICES/sSEED", "blocks between crooked streets"}, structured_map<StructuredKind::kCity>},
      {{"islands", {}, "islands/vVERTICES/sSEED", "smooth closed curves of many vertices"},
       structured_map<StructuredKind::kIslands>},
      {{"corridor", {}, "corridor/vVERTICES/sSEED", "long corridors between rough walls, joined at their ends"},
       structured_map<StructuredKind::kCorridor>},
      {{"coastline", {}, "coastline/vVERTICES/sSEED", "one island with all the vertices"},
       structured_map<StructuredKind::kCoastline>},
      {{"ponds", {}, "ponds/nPONDS/tTOLERANCE_MM/sSEED", "splines, as rings that contain them within a tolerance"},
       ponds_map},
      {{"adversarial",
        {"touching", "shared", "collinear", "needles", "far", "nested", "overlapping", "contacts", "holes", "saw",
         "comb", "spikes", "rings"},
        "adversarial/KIND/vVERTICES/sSEED",
        "legal maps made to break predicates"},
       adversarial_map},
      {{"driven",
        {"scattered", "hugging", "carved", "rooms"},
        "driven/KIND/rROBOT/gGEARS/cCLEARANCE_MM/sSEED",
        "obstacles beside a drive of one of nine robots, in one or two gears, so that a way is known"},
       driven_map},
  };
  return all;
}

}  // namespace

std::span<const CatalogFamily> catalog_families() {
  static const std::vector<CatalogFamily> families = [] {
    std::vector<CatalogFamily> list;
    for (const Entry& entry : entries()) list.push_back(entry.family);
    return list;
  }();
  return families;
}

bool is_catalog_name(std::string_view name) { return find_entry(name) != nullptr; }

MapFile catalog_map(std::string_view name) {
  const Parts parts(name);
  return parts.entry().make(parts);
}

std::optional<DrivenWorld> catalog_driven_world(std::string_view name) {
  const Parts parts(name);
  if (parts.entry().make != driven_map) return std::nullopt;
  return driven_world(parts);
}

World catalog_world(std::string_view name) { return to_world(catalog_map(name), name); }

std::vector<PlanRequest> catalog_queries(std::string_view name, std::size_t count, std::uint64_t seed) {
  const World world = catalog_world(name);
  return random_queries(world, make_reference_queries(world), Vehicle(), {.count = count, .seed = seed});
}

}  // namespace arcway
