#pragma once

namespace arcway {

/// How a graph search times paths. Every path that it returns has its true time in either model.
enum class TimeModel {
  kProfile,  ///< the true speed profile, over as many segments as speeding up and braking take
  kSegments  ///< each segment on its own by (9) and (10), as in the paper; arcs at v_mc, however short the lines beside
             ///< them are
};

}  // namespace arcway
