#pragma once

/// \file
/// What the shared libraries export. All else in them is hidden.

#if defined(__GNUC__)
#define ARCWAY_API [[gnu::visibility("default")]]
#else
#define ARCWAY_API
#endif
