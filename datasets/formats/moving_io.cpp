#include "arcway/datasets/moving_io.h"

#include <cstddef>
#include <string>

#include "datasets/io/json_text.h"

namespace arcway {

using namespace internal::detail;
namespace {

Vec2 vector_of(const JsonPlace& place) {
  place.require_array();
  if (place.value.size() != 2) place.expected("two numbers");
  return {place.at(std::size_t{0}).number(), place.at(std::size_t{1}).number()};
}

MovingObstacle obstacle_of(const JsonPlace& place) {
  place.require_object();
  place.allow_keys({"outline", "velocity", "from", "until"});
  MovingObstacle obstacle;
  const JsonPlace outline = place.at("outline");
  outline.require_array();
  for (std::size_t i = 0; i < outline.value.size(); ++i) obstacle.outline.push_back(vector_of(outline.at(i)));
  if (obstacle.outline.size() > 1 && obstacle.outline.front() == obstacle.outline.back()) obstacle.outline.pop_back();
  obstacle.velocity = vector_of(place.at("velocity"));
  if (place.has("from")) obstacle.from = place.at("from").number();
  if (place.has("until")) obstacle.until = place.at("until").number();
  return obstacle;
}

}  // namespace

std::vector<MovingObstacle> parse_moving_obstacles(std::string_view text, std::string_view name) {
  const nlohmann::json json = parse_json(text, name);
  const JsonPlace document{json, std::string(name)};
  document.require_object();
  document.allow_format("arcway-moving", 1);
  document.allow_keys({"format", "version", "obstacles"});
  const JsonPlace obstacles = document.at("obstacles");
  obstacles.require_array();
  std::vector<MovingObstacle> read;
  for (std::size_t i = 0; i < obstacles.value.size(); ++i) read.push_back(obstacle_of(obstacles.at(i)));
  return read;
}

std::vector<MovingObstacle> read_moving_obstacles(const std::filesystem::path& file) {
  return parse_moving_obstacles(read_file(file), file.string());
}

}  // namespace arcway
