#include "datasets/formats/tpcap.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/base/shortest_text.h"
#include "datasets/formats/text_scanner.h"
#include "datasets/formats/vector_map.h"

namespace arcway::internal {
namespace {

constexpr double kRoom = 12.0;     // around start and goal [m]
constexpr double kFarAway = 1e6;   // [m]
constexpr double kMaxCount = 1e7;  // obstacles, or vertices of one

class TpcapReader {
 public:
  TpcapReader(std::string_view text, std::string_view name) : text_(text, name), map_(name, {}) {}

  MapFile read() {
    Pose start = pose("start"), goal = pose("goal");
    const std::size_t obstacles = count("the number of obstacles");
    std::vector<std::size_t> sizes;
    for (std::size_t i = 0; i < obstacles; ++i) sizes.push_back(count("the vertices of obstacle " + std::to_string(i)));
    std::vector<Ring> rings(obstacles);
    for (std::size_t i = 0; i < obstacles; ++i) {
      const std::string what = "vertex of obstacle " + std::to_string(i);
      for (std::size_t k = 0; k < sizes[i]; ++k) {
        const double x = next("x of a " + what), y = next("y of a " + what);
        rings[i].emplace_back(x, y);
      }
    }
    skip_separators();
    if (!text_.at_end()) text_.expected("the end of the file after all obstacles");

    move_to_origin(start, goal, rings);
    Box box;
    for (const Pose& pose : {start, goal}) {
      box.extend(pose.position() - Vec2(kRoom, kRoom));
      box.extend(pose.position() + Vec2(kRoom, kRoom));
    }
    for (std::size_t i = 0; i < obstacles; ++i) {
      const std::string place = "obstacle " + std::to_string(i);
      Ring ring = map_.ring(std::move(rings[i]), /*closed=*/false, place);
      for (const Vec2& p : ring) box.extend(p);
      map_.add_obstacle({std::move(ring), {}}, place);
    }
    map_.set_bounds({{box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}}, {}}, "bounds");
    map_.map().start = start;
    map_.map().goal = goal;
    map_.set_planar();
    return map_.finish();
  }

 private:
  void skip_separators() {
    text_.skip_space();
    if (text_.accept(',')) text_.skip_space();
  }
  double next(const std::string& what) {
    skip_separators();
    return text_.number(what);
  }
  Pose pose(const std::string& what) {
    const double x = next("x of the " + what), y = next("y of the " + what);
    return {x, y, next("heading of the " + what)};
  }
  std::size_t count(const std::string& what) {
    skip_separators();
    const detail::TextScanner before = text_;
    const double value = text_.number(what);
    if (!(value >= 0.0 && value <= kMaxCount && value == std::floor(value)))
      before.expected(what + " as a whole number");
    return static_cast<std::size_t>(value);
  }

  // By whole meters: the differences are exact for all that is as far away as the start.
  void move_to_origin(Pose& start, Pose& goal, std::vector<Ring>& rings) {
    if (start.position().cwiseAbs().maxCoeff() <= kFarAway) return;
    const Vec2 by(-std::round(start.x), -std::round(start.y));
    for (Pose* pose : {&start, &goal}) {
      pose->x += by.x();
      pose->y += by.y();
    }
    for (Ring& ring : rings)
      for (Vec2& p : ring) p += by;
    map_.map().notes.push_back("moved by (" + shortest_text(by.x()) + ", " + shortest_text(by.y()) + ") m");
  }

  detail::TextScanner text_;
  detail::VectorMapBuilder map_;
};

}  // namespace

MapFile read_tpcap(std::string_view text, std::string_view name) { return TpcapReader(text, name).read(); }

}  // namespace arcway::internal
