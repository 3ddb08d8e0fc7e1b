#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "planner/gcode/action.hpp"
#include "planner/geometry/arc_elements.hpp"
#include "planner/geometry/arc_fit.hpp"
#include "planner/geometry/path_element.hpp"

namespace cnc {

/// One element of an action's path.
struct ActionPart {
  PathElement element{};
  float feed_mm_s = 0.0F;  ///< Feed as in motion::MotionRequest, mm/s; 0 means a rapid.
  /// Whether the element and the element before it are parts of one curve.
  bool continues = false;
  std::uint32_t index = 0;         ///< Index of the element, as in motion::SourceLine.
  std::optional<float> power_s{};  ///< Value of S from this part on; empty if S stays unchanged.
  /// Values of S for the equal parts of a line that is one element, a row. Empty for all other
  /// elements.
  std::span<const float> row{};
};

/// Divides an action of G-code that moves the tool into path elements. A straight line becomes one
/// element, and a line with several powers becomes equal parts. An arc or a helix becomes elements
/// of at most half a turn, and a spline becomes arcs within a tolerance.
///
/// The elements are computed one at a time, so that a caller whose capacity is exhausted can
/// continue later. Consecutive elements join exactly, and the last element ends at the action's
/// end. Main loop only; nothing is allocated.
class ActionElements {
 public:
  /// Returns whether begin() accepts the action: it moves along a path that the action alone
  /// determines. A probing motion does not, because the contact ends it.
  [[nodiscard]] static bool accepts(const gcode::Action& action);

  /// Begins an action and forgets the action before it.
  /// @param action its powers and its spline must stay valid until the last element is taken
  /// @param from end of the path so far, machine coordinates
  /// @param spline_tolerance_mm greatest distance of arcs from their spline; at least
  ///     ArcFit::kMinToleranceMm
  /// @param min_parts least number of elements into which an arc, a line or each part of a line
  ///     with several powers is divided; at least 1
  /// @param rows whether a line with several powers may be one element
  /// @pre accepts(action)
  void begin(const gcode::Action& action,
             const Position& from,
             float spline_tolerance_mm,
             std::uint32_t min_parts = 1,
             bool rows = false);
  /// Forgets the action.
  void clear() { curve_ = Curve::kNone; }

  /// Returns whether an action has been begun and not cleared.
  [[nodiscard]] bool active() const { return curve_ != Curve::kNone; }
  /// Returns whether no element is left. @pre active()
  [[nodiscard]] bool done() const;

  /// Returns the number of pixels of the next element if it is a row; 0 for all other elements.
  /// @pre active()
  [[nodiscard]] std::size_t pixels() const {
    return curve_ == Curve::kLine && line_.is_row ? line_.powers.size() : 0;
  }

  /// Works on the next element. Only elements of a spline require any work.
  /// @param points budget of curve points, from which the evaluated points are subtracted; exceeded
  ///     by at most ArcFit::kPointsAtOnce
  /// @return true if the next element is ready for next()
  /// @pre !done()
  [[nodiscard]] bool work(std::uint32_t& points);
  /// Returns the next element and advances. @pre !done()
  [[nodiscard]] ActionPart next();

 private:
  enum class Curve : std::uint8_t { kNone, kLine, kArc, kSpline };
  struct Line {
    Position from{};
    Position end{};
    /// One power for each equal part; empty if S stays unchanged.
    std::span<const float> powers{};
    std::uint32_t parts = 1;  ///< Number of elements in each equal part.
    bool is_row = false;      ///< Whether the line is one element, in spite of its powers.

    [[nodiscard]] std::uint32_t count() const;
    [[nodiscard]] Position end_of(std::uint32_t part) const;
  };

  [[nodiscard]] ActionPart next_of(const Line& line) const;

  // The members are no std::variant, because a compiler that optimizes for size may add a call of
  // abort() to accesses of a variant.
  Curve curve_ = Curve::kNone;
  Line line_{};
  std::optional<ArcElements> arc_{};
  std::optional<ArcFit> spline_{};
  Position here_{};  ///< End of the elements so far.
  float feed_mm_s_ = 0.0F;
  std::uint32_t taken_ = 0;  ///< Number of elements so far.
};

}  // namespace cnc
