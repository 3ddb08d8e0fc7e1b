#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

namespace sim {

/// Builds the attributes `values` and `keyTimes` of one animation. add() replaces a share that is
/// smaller than the preceding share by the preceding share. The last share must be 1.
class KeyFrames {
 public:
  void add(double share, std::string_view value) {
    last_ = std::max(last_, std::clamp(share, 0.0, 1.0));
    const std::string_view separator = values_.empty() ? "" : ";";
    fmt::format_to(std::back_inserter(values_), "{}{}", separator, value);
    fmt::format_to(std::back_inserter(times_), "{}{:.7g}", separator, last_);
  }

  /// Returns the attributes as `values="…" keyTimes="…"`.
  [[nodiscard]] std::string attributes() const {
    return fmt::format(R"(values="{}" keyTimes="{}")", values_, times_);
  }

 private:
  std::string values_;
  std::string times_;
  double last_ = 0.0;
};

/// The duration of a job, and the duration of its animation.
struct AnimationTime {
  double total_s = 1.0;  ///< Duration of the job, > 0.
  double shown_s = 1.0;  ///< Duration of the animation, > 0.

  /// Returns the attributes that all animations of a document must have in common, so that they
  /// stay synchronous.
  [[nodiscard]] std::string attributes() const {
    return fmt::format(R"(dur="{:.3f}s" repeatCount="indefinite")", shown_s);
  }
};

}  // namespace sim
