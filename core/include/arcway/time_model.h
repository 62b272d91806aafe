#pragma once

namespace arcway {

/// How a search times paths; what it finds has its true time whatever this is.
enum class TimeModel {
  kProfile,  ///< by the true speed profile, whatever number of segments speeding up and braking take
  kSegments  ///< segment by segment by (9) and (10), as the paper has it: arcs at v_mc however short the lines between
             ///< them are
};

}  // namespace arcway
