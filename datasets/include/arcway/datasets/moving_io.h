#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "arcway/export.h"
#include "arcway/moving_obstacle.h"

namespace arcway {

/// Reads moving obstacles: "from" and "until" may be left out [m, m/s, s].
///
///     {"format":"arcway-moving","version":1,
///      "obstacles":[{"outline":[[x,y],..],"velocity":[vx,vy],"from":0,"until":10}]}
///
/// An outline may repeat its first vertex at the end, and have either orientation.
/// @param name  what messages call the text.
/// @throws FormatError naming the place and the value. Outlines are checked where they are used, see conflicts().
ARCWAY_API std::vector<MovingObstacle> parse_moving_obstacles(std::string_view text, std::string_view name);

/// parse_moving_obstacles of a file.
/// @throws std::runtime_error if it cannot be read.
ARCWAY_API std::vector<MovingObstacle> read_moving_obstacles(const std::filesystem::path& file);

}  // namespace arcway
