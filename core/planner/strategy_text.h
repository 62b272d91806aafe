#pragma once

#include <string>

#include "core/planner/strategy_row.h"

namespace arcway::internal {

/// "no path yet, one gear, gap > 4 %"; "always" if nothing is asked.
std::string text_of(const When& when);
/// What the step does, in words, with its numbers.
std::string text_of(const Step& step);
/// "0.75 x, with several radii", say; empty for as many as the options say.
std::string text_of(const Trials& trials);

}  // namespace arcway::internal
