#pragma once

#include <string_view>

namespace arcway::internal {

// What the parts of a picture share.

inline constexpr double kBorder = 16.0;  // around the map [px]
inline constexpr double kLetter = 8.6;   // width of a bold letter, on the safe side [px]
inline constexpr const char* kFreeColor = "#fbfcfe";
inline constexpr const char* kOutsideColor = "#aeb7c4";
inline constexpr const char* kPathColor = "#e4572e";
inline constexpr const char* kReverseColor = "#1f6fd1";
inline constexpr std::string_view kHalo = R"( stroke="#ffffff" stroke-width="3" paint-order="stroke")";

}  // namespace arcway::internal
