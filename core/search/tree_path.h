#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "arcway/path.h"

namespace arcway::internal {

/// The motions between a node of a tree and its root, node 0; the motion to the node first. O(depth).
/// @param nodes  each with a `motion` and the index of its `parent`.
template <class Node>
Path motions_up(const std::vector<Node>& nodes, std::uint32_t node) {
  Path path;
  for (; node != 0; node = nodes[node].parent) path.push_back(nodes[node].motion);
  return path;
}

/// The path from the root of a tree to a node. O(depth).
template <class Node>
Path path_from_root(const std::vector<Node>& nodes, std::uint32_t node) {
  Path path = motions_up(nodes, node);
  std::reverse(path.begin(), path.end());
  return path;
}

/// The path from a node of a tree back to its root, each motion reversed. O(depth).
template <class Node>
Path path_to_root(const std::vector<Node>& nodes, std::uint32_t node) {
  Path path = motions_up(nodes, node);
  for (PathSegment& motion : path) motion = motion.reversed();
  return path;
}

}  // namespace arcway::internal
