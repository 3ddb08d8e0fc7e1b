#pragma once

#include <algorithm>

#include "planner/base/scalar_math.hpp"
#include "planner/motion/block/block.hpp"
#include "planner/motion/block/limits.hpp"

namespace cnc::motion {

/// The limit of the speed on a block that follows from its programmed feed and the overrides.
class SpeedCap {
 public:
  SpeedCap(const Block& block, const Overrides& overrides)
      : feed_square_{block.is_rapid()
                         ? 1.0e12F
                         : square(block.fixed_feed ? block.feed : block.feed * overrides.feed)},
        rapid_factor_{block.is_rapid() && !block.fixed_feed ? square(overrides.rapid) : 1.0F} {}

  /// Returns the greatest v² at a position where the machine's own limit of v² is `limit_square`.
  [[nodiscard]] float square_within(float limit_square) const {
    return std::min(feed_square_, limit_square * rapid_factor_);
  }

 private:
  float feed_square_;
  float rapid_factor_;
};

}  // namespace cnc::motion
