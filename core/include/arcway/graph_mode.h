#pragma once

namespace arcway {

/// When the free headings and bitangents of a feasible visibility graph are checked.
enum class GraphMode {
  kEager,  ///< all when the graph is built: for many queries on one map
  kLazy    ///< each when a search first needs it, and then kept: for few queries
};

}  // namespace arcway
