#pragma once

#include <cstdint>

#include "planner/path/path_item.hpp"

namespace cnc {

/// Continues a program from where it was interrupted. From the line that was driven then, its path
/// is driven with the beam off; from the point that the tool had reached, with the beam on. So the
/// beam comes on at speed, and no more than a step or two is burnt twice.
class Reentry {
 public:
  /// Greatest number of lines between the known line and the point: lines of a weld, or lines that
  /// shapers delay.
  static constexpr std::uint32_t kMaxLines = 4096;

  enum class Verdict : std::uint8_t {
    kDark,   ///< Beam off for the whole element, which may end at the point.
    kSplit,  ///< Beam off up to the element's new end; the rest of the element has the beam on.
    kLit,    ///< The point has been passed: the beam is on.
    kLost,   ///< The path does not pass the point.
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

  /// Decides about the beam on the next element of the path, and splits the element if necessary.
  /// @pre active()
  /// @param beside_mm greatest distance of the point from the element
  [[nodiscard]] Verdict judge(path::PathItem& item, float beside_mm);

  /// Returns whether an element was split and its rest waits.
  [[nodiscard]] bool has_rest() const { return has_rest_; }
  /// Returns the rest of the split element, otherwise unchanged.
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
