#include "core/search/search_map.h"

#include <utility>

namespace arcway {

SearchMap::SearchMap(const World& w, const Vehicle& v, QuerySet q, std::vector<double> r, FeasibleGraph g)
    : world(w),
      vehicle(v),
      queries(std::move(q)),
      radii(std::move(r)),
      graph(std::move(g)),
      body(v.footprint(0.5 * v.safety_margin())),
      outlines(std::make_shared<const Outlines>(w)) {}

}  // namespace arcway
