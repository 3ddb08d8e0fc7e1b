#pragma once

#include <cstdint>

#include "planner/path/path_item.hpp"

namespace cnc {

/// Takes a program up again where it was interrupted: its path is driven dark from the line on
/// that was driven then, and lit from the place on that the tool had come to. So the beam
/// comes on at speed, and no more than a step or two is burnt twice.
class Reentry {
 public:
  /// How many lines may lie between the one that is known and the place: those of a weld, or of
  /// what shapers delay.
  static constexpr std::uint32_t kMostLines = 4096;

  enum class Verdict : std::uint8_t {
    kDark,   ///< The whole element; who has come to its end need not look at the next.
    kSplit,  ///< Dark to its new end; what is left of it is lit.
    kLit,    ///< The place is behind: nothing more to do.
    kLost,   ///< The path does not pass the place.
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

  /// What becomes of the next element of the path. @pre active()
  /// @param beside_mm how far from it the place may be
  [[nodiscard]] Verdict judge(path::PathItem& item, float beside_mm);

  /// What is left of the element that was split, as it came.
  [[nodiscard]] bool has_rest() const { return has_rest_; }
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
