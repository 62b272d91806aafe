#pragma once

#include <string>
#include <string_view>

namespace arcway::internal::report {

/// A stage of benchmarks in words: "Reduced visibility graph" for "ReducedGraph". A name that is not known is split
/// where a word begins: "Fast thing" for "FastThing".
std::string stage_words(std::string_view stage);

/// What a series goes over, in words: "share of the map that obstacles cover, in percent" for "fill_percent". A name
/// that is not known has spaces for underscores.
std::string key_words(std::string_view key);

/// A counter in words: spaces for underscores.
std::string counter_words(std::string_view counter);

/// What planners were compared on, in words: "the paper's robot, 100 obstacles" for "n100". A name that is not known
/// stays as it is.
std::string setting_words(std::string_view setting);

/// A planner in words: "OMPL's RRTConnect, 10 s" for "ompl_rrtconnect 10 s". A name that is not known stays as it is.
std::string planner_words(std::string_view planner);

/// An anchor of a page: lowercase letters, digits and dashes.
std::string anchor_of(std::string_view title);

}  // namespace arcway::internal::report
