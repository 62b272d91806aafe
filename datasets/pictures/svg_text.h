#pragma once

#include <string>
#include <string_view>

#include "arcway/vec2.h"

namespace arcway::internal {

// Appends a number, rounded to 1 / parts: "12.3", "12".
void append(std::string& out, double value, double parts = 10.0);

// Appends a point of the picture [px].
void append(std::string& out, const Vec2& p);

// The start of a group that Inkscape shows as a layer.
std::string open_layer(const std::string& id, const std::string& attributes);

// A colored square, for a caption.
std::string square(std::string_view color);

}  // namespace arcway::internal
