#pragma once

#include <memory>
#include <string>
#include <vector>

#include "arcway/world.h"

namespace arcway::internal::peers {

/// CGAL's triangular expansion visibility [Bungiu et al. 2014], the fastest of CGAL's visibility algorithms. It runs
/// with exact predicates and constructions, as its documentation asks for. With rounded constructions answers are wrong
/// or the process ends. It serves worlds with bounds whose regions do not touch or cross.
class CgalVisibility {
 public:
  /// Builds the arrangement and its triangulation.
  explicit CgalVisibility(const World& world);
  ~CgalVisibility();
  CgalVisibility(const CgalVisibility&) = delete;
  CgalVisibility& operator=(const CgalVisibility&) = delete;

  /// All vertices on the border of what a vertex sees, ascending, without the vertex.
  [[nodiscard]] std::vector<VertexId> visible_from(VertexId v) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// CGAL's constrained Delaunay triangulation of all vertices and edges: what any builder on triangles must do first.
/// Predicates are exact. All constraints are inserted at once, in CGAL's own spatial order, which is fastest.
/// @return  number of triangles.
std::size_t triangulate_by_cgal(const World& world);

/// Version of CGAL: "5.5.1".
std::string cgal_version();

}  // namespace arcway::internal::peers
