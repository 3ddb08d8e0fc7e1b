#pragma once

#include "planner/motion/motion_filter.hpp"
#include "planner/motion/speed_profile.hpp"

namespace cnc::motion {

class Segmenter;

/// What a segmenter needs only while its motion is under way: how fast the block may be driven,
/// span by span, and what the plan did within the last window. 4.1 KB.
///
/// Segmenters of which one moves at a time may share it. Whoever begins a motion has it until
/// that motion stands; one that was halted and finds it used works out anew what it needs.
struct SegmenterRoom {
  SpeedProfile profile{};
  MotionFilter filter{};
  const Segmenter* user = nullptr;  ///< Whose motion they are of; null when that was forgotten.
};

}  // namespace cnc::motion
