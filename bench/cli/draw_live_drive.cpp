#include "bench/cli/draw_live_drive.h"

#include <memory>

#include "arcway/backend.h"
#include "arcway/executor.h"
#include "bench/cli/arguments.h"

namespace arcway::internal::cli {

figures::LiveFigures draw_live_drive() {
  const BuildOptions build;
  const std::unique_ptr<const Executor> executor = build.executor();
  return figures::live_drive([&](const World& world) {
    return build.backend == "reference" ? reference_backend(world)
                                        : build.backend_for(world, *executor, kSingleProcess);
  });
}

}  // namespace arcway::internal::cli
