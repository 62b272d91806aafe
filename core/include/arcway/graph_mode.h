#pragma once

namespace arcway {

/// When a feasible visibility graph is checked.
enum class GraphMode {
  kEager,  ///< everything is checked when the graph is built: for many queries on one map
  kLazy    ///< headings and bitangents are checked when a search first asks for them, and remembered: for few
};

}  // namespace arcway
