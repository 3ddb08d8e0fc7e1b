#pragma once

#include <cstdint>

#include "planner/path/path_item.hpp"

namespace cnc {

/// Continues a program from the point at which it was interrupted. Up to this point the path is
/// driven with the beam off, and from this point on with the beam on. So the beam goes on while the
/// tool moves at full speed, and at most one or two steps of the path are burnt twice.
class Reentry {
 public:
  /// Maximum number of lines from the noted line to the line of the point. They may be different
  /// lines, because lines are welded and shapers delay the motion.
  static constexpr std::uint32_t kMaxLines = 4096;

  enum class Verdict : std::uint8_t {
    kDark,   ///< The beam is off along the complete element. The point may be its end.
    kSplit,  ///< The element was split at the point: its beam is off, and rest() has the beam on.
    kLit,    ///< The element begins at the point: its beam is on.
    kLost,   ///< The path has not passed the point within kMaxLines.
  };

  void begin(motion::SourceLine line, const Position& place) {
    line_ = line;
    place_ = place;
    active_ = true;
  }
  void cancel() {
    active_ = false;
    has_rest_ = false;
  }
  [[nodiscard]] bool active() const { return active_; }

  /// Decides whether the beam is on along the next element of the path. Splits the element if it
  /// contains the point.
  /// @pre active()
  /// @param beside_mm maximum distance of the point from an element that contains it
  [[nodiscard]] Verdict judge(path::PathItem& item, float beside_mm);

  /// Returns whether an element was split and its second part waits to be driven.
  [[nodiscard]] bool has_rest() const { return has_rest_; }
  /// Returns the second part of the split element, with the beam on.
  /// @pre has_rest()
  [[nodiscard]] const path::PathItem& rest() const { return rest_; }
  void drop_rest() { has_rest_ = false; }

 private:
  [[nodiscard]] bool may_hold(motion::SourceLine line) const;

  motion::SourceLine line_{};
  Position place_{};
  bool active_ = false;
  bool has_rest_ = false;
  path::PathItem rest_{};
};

}  // namespace cnc
