#pragma once

// Of the consumer, not of the library.
inline constexpr double kTopFloor = 7.0;
