#pragma once

/// \file
/// ARCWAY_API marks what the shared libraries export. All other symbols are hidden.

#if defined(__GNUC__)
#define ARCWAY_API [[gnu::visibility("default")]]
#else
#define ARCWAY_API
#endif
