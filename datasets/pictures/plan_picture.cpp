#include <stdexcept>
#include <vector>

#include "arcway/datasets/file_io.h"
#include "arcway/datasets/svg.h"

namespace arcway {

void write_svg(const std::filesystem::path& path, const PlanResult& result) {
  if (!result.scene)
    throw std::invalid_argument("write_svg: no planner made this result, so that its world is not known");
  const Body body = result.scene->vehicle.body();
  const Path driven = result.path();
  Box view = result.scene->world.box();
  std::vector<Vec2> places = polyline(driven, std::max(body.length(), 1e-4 * result.length));
  places.insert(places.end(), {result.start.position(), result.goal.position()});
  for (const Vec2& p : places) view.extend(Box{p, p}.grown(body.farthest()));
  SvgPicture picture(result.scene->world, view);
  picture.add_axes();
  if (result.solved()) {
    picture.add_swept_area(driven, body);
    picture.add_path(driven, body, to_string(result));
    picture.add_speeds(result.trajectory());
  } else {
    picture.add_bodies(std::vector{result.start, result.goal}, body);
    picture.add_poses(result.start, result.goal, body);
    picture.add_caption(to_string(result));
  }
  picture.set_title(name_of(result.status));
  write_file_atomically(path, picture.str());
}

}  // namespace arcway
