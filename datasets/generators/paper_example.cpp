#include "arcway/datasets/paper_example.h"

#include "arcway/angle.h"

namespace arcway {

PaperExample paper_example() {
  std::vector<Polygon> obstacles;
  const auto add = [&](Ring ring) { obstacles.push_back({std::move(ring), {}}); };
  add({{90, 130}, {190, 95}, {255, 150}, {235, 235}, {140, 250}});
  add({{330, 50}, {430, 30}, {475, 110}, {420, 190}, {345, 165}});
  add({{560, 60}, {700, 45}, {725, 120}, {640, 185}, {575, 150}});
  add({{60, 360}, {150, 320}, {220, 380}, {205, 480}, {110, 500}});
  add({{300, 270}, {400, 240}, {450, 320}, {410, 390}, {320, 375}});
  add({{520, 240}, {620, 250}, {680, 330}, {600, 400}, {515, 345}});
  add({{340, 455}, {450, 440}, {540, 480}, {500, 555}, {370, 550}});
  add({{740, 230}, {840, 215}, {860, 330}, {790, 460}, {700, 430}});
  return {World(std::move(obstacles), Ring{{0, 0}, {900, 0}, {900, 600}, {0, 600}}),
          VehicleParameters{},
          {30.0, 30.0, kPi / 2.0},
          {850.0, 550.0, kPi / 2.0}};
}

}  // namespace arcway
