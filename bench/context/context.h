#pragma once

#include <string>
#include <utility>
#include <vector>

namespace arcway::internal::bench {

/// Keys and values that every file of results carries: processor, cores, instruction set, compiler, flags, build type,
/// commit, versions of the libraries. Nothing that names the machine or its user.
std::vector<std::pair<std::string, std::string>> machine_and_build();

}  // namespace arcway::internal::bench
