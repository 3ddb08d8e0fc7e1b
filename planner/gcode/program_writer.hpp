#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "planner/base/axes.hpp"
#include "planner/base/result.hpp"
#include "planner/gcode/centre_on_grid.hpp"
#include "planner/gcode/line_text.hpp"
#include "planner/gcode/print_grid.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc::gcode {

enum class WriterError : std::uint8_t {
  kOutOfRange,  ///< A value is NaN, or its distance from zero exceeds kFarthestOnGrid.
  kTooFlat,     ///< The distance of the arc's centre exceeds kFarthestCentre.
};

/// Writes motion as G-code in mm, with absolute positions and with centres relative to the start of
/// the arc. Printed positions differ from the given ones by at most one unit of the last digit.
/// Centres have one more digit than positions. So the radii at both ends of an arc agree within a
/// fraction of this unit, and the reader does not have to repair the arc.
///
/// Positions are in the XY plane and heights along Z, until use_plane() selects another plane. Then
/// a position gives the first and the second axis of that plane, and a height is along its normal.
/// Without set_height() no line has a Z.
///
/// A line contains only the words that differ from the line before. Each call returns complete
/// lines with their ends, or an empty text if nothing moves. The text is valid until the next call.
/// A refused call writes nothing and changes nothing.
class ProgramWriter {
 public:
  explicit ProgramWriter(PrintGrid grid) : grid_{grid} {}

  /// Set the feed and the power of the following motions, in thousandths of mm/min and of S.
  void set_feed(std::uint32_t thousandths) { feed_ = thousandths; }
  void set_power(std::uint32_t thousandths) { power_ = thousandths; }

  /// Omits S in all following lines, because S would be the speed of a spindle.
  void leave_power() { power_ = written_power_ = 0; }
  /// Sets the height at the end of the next motion, in mm. Returns false and changes nothing if the
  /// height is NaN or its distance from zero exceeds kFarthestOnGrid. If this function is never
  /// called, no line has a Z.
  template <std::floating_point Scalar>
  [[nodiscard]] bool set_height(Scalar height_mm);

  /// Returns the line that selects the plane of arcs, or an empty text if the plane is already
  /// selected.
  /// @pre a motion and a height have been written
  [[nodiscard]] std::string_view use_plane(Plane plane);
  [[nodiscard]] Plane plane() const { return plane_; }

  /// Writes a G0. A change of the height is a separate motion. An upward change comes before the
  /// motion in the plane, and a downward change after it. @pre the plane is XY
  template <std::floating_point Scalar>
  [[nodiscard]] Result<std::string_view, WriterError> rapid(const BasicVec2<Scalar>& to);

  /// Writes a G1, G2 or G3. The motion is a line if the bulge is 0. Otherwise it is an arc of less
  /// than a full turn with the bulge tan(sweep / 4). An arc of more than half a turn is written as
  /// two arcs. An arc whose sagitta is below a quarter of a unit of the last digit is written as a
  /// line. The height changes in proportion to the length.
  /// @pre `from` is the end of the last motion, within half a unit of the last digit
  template <std::floating_point Scalar>
  [[nodiscard]] Result<std::string_view, WriterError> cut(const BasicVec2<Scalar>& from,
                                                          const BasicVec2<Scalar>& to,
                                                          Scalar bulge);

  /// Returns the end of the last motion; empty before the first motion.
  [[nodiscard]] const std::optional<GridPlace>& place() const { return place_; }

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;
  static constexpr int kNoMotion = -1;

  template <std::floating_point Scalar>
  [[nodiscard]] std::optional<GridPlace> on_grid(const BasicVec2<Scalar>& place_mm) const;
  template <std::floating_point Scalar>
  [[nodiscard]] bool add_arc(GridPlace to, GridPlace middle, Scalar bulge);
  void add_line(GridPlace to);
  void add_arc(GridPlace to, GridCentre centre, bool clockwise);
  /// Adds the rapids to a position and to the height at the end of the motion.
  void add_rapids(GridPlace to);
  [[nodiscard]] bool is_at_height() const { return !height_ || height_ == written_height_; }
  /// Returns the height in the middle of the motion, in units of the last printed digit. It is the
  /// height at the end of the first part of a motion that is written as two.
  [[nodiscard]] std::optional<std::int32_t> half_way() const;
  /// Adds the G word if it changes, and those coordinates of the end that change.
  void add_motion(int motion, GridPlace to);
  /// Adds the word of the height if it changes; this is Z in the XY plane.
  void add_height();
  void end_line(GridPlace to);

  PrintGrid grid_;
  Plane plane_ = Plane::kXY;
  LineText text_{};
  std::optional<GridPlace> place_{};
  int motion_ = kNoMotion;
  /// Height at the end of the next motion, in units of the last printed digit.
  std::optional<std::int32_t> height_{};
  /// Last height that was written, in units of the last printed digit; empty before the first one.
  std::optional<std::int32_t> written_height_{};
  std::uint32_t feed_ = 0;
  std::uint32_t power_ = 0;
  std::uint32_t written_feed_ = kNone;
  std::uint32_t written_power_ = kNone;
};

template <std::floating_point Scalar>
std::optional<GridPlace> ProgramWriter::on_grid(const BasicVec2<Scalar>& place_mm) const {
  const auto scale = static_cast<Scalar>(grid_.per_mm());
  constexpr auto kFarthest = static_cast<Scalar>(kFarthestOnGrid);
  const Scalar x = place_mm.x() * scale;
  const Scalar y = place_mm.y() * scale;
  if (!(std::abs(x) <= kFarthest && std::abs(y) <= kFarthest)) return std::nullopt;
  return GridPlace{static_cast<std::int32_t>(rounded(x)), static_cast<std::int32_t>(rounded(y))};
}

template <std::floating_point Scalar>
bool ProgramWriter::set_height(Scalar height_mm) {
  const Scalar height = height_mm * static_cast<Scalar>(grid_.per_mm());
  if (!(std::abs(height) <= static_cast<Scalar>(kFarthestOnGrid))) return false;
  height_ = static_cast<std::int32_t>(rounded(height));
  return true;
}

template <std::floating_point Scalar>
Result<std::string_view, WriterError> ProgramWriter::rapid(const BasicVec2<Scalar>& to) {
  CNC_ASSERT(plane_ == Plane::kXY);
  const auto end = on_grid(to);
  if (!end) return WriterError::kOutOfRange;
  text_.clear();
  add_rapids(*end);
  return text_.view();
}

/// Adds an arc from the end of the last motion. An arc below the least radius is replaced by two
/// lines. Returns false and adds nothing if the centre is too far away.
/// @param middle position in the middle of the arc, where the two lines meet
template <std::floating_point Scalar>
bool ProgramWriter::add_arc(GridPlace to, GridPlace middle, Scalar bulge) {
  constexpr auto kMinRadius = static_cast<Scalar>(kMinRadiusOnGrid);
  const GridPlace chord = to - *place_;
  const auto x = static_cast<Scalar>(chord.x);
  const auto y = static_cast<Scalar>(chord.y);
  const Scalar length = std::sqrt(x * x + y * y);
  const Scalar size = std::abs(bulge);
  if (size * length < Scalar{0.5}) {
    add_line(to);
    return true;
  }
  if (length * (Scalar{1} + size * size) < Scalar{4} * size * kMinRadius) {
    const auto end = std::exchange(height_, half_way());
    add_line(middle);
    height_ = end;
    add_line(to);
    return true;
  }
  const auto centre = centre_on_grid(chord, bulge);
  if (!centre) return false;
  add_arc(to, *centre, bulge < 0);
  return true;
}

template <std::floating_point Scalar>
Result<std::string_view, WriterError> ProgramWriter::cut(const BasicVec2<Scalar>& from,
                                                         const BasicVec2<Scalar>& to,
                                                         Scalar bulge) {
  const auto apex_of = [](const BasicVec2<Scalar>& a, const BasicVec2<Scalar>& b, Scalar arc) {
    const BasicVec2<Scalar> chord = b - a;
    return BasicVec2<Scalar>{Scalar{0.5} * (a + b) - Scalar{0.5} * arc * left_normal(chord)};
  };
  const auto start = on_grid(from);
  const auto end = on_grid(to);
  const BasicVec2<Scalar> apex = apex_of(from, to, bulge);
  const auto middle = on_grid(apex);
  if (!start || !end || !middle) return WriterError::kOutOfRange;
  CNC_ASSERT(place_.has_value());
  text_.clear();
  const ProgramWriter before = *this;
  // The bulge of half of the arc, tan(sweep / 8).
  const Scalar half = bulge / (Scalar{1} + std::sqrt(Scalar{1} + bulge * bulge));
  bool done = true;
  if (std::abs(bulge) <= Scalar{1}) {
    done = add_arc(*end, *middle, bulge);
  } else {
    const auto first = on_grid(apex_of(from, apex, half));
    const auto second = on_grid(apex_of(apex, to, half));
    if (!first || !second) return WriterError::kOutOfRange;
    const auto height = std::exchange(height_, half_way());
    done = add_arc(*middle, *first, half);
    height_ = height;
    done = done && add_arc(*end, *second, half);
  }
  if (done) return text_.view();
  *this = before;
  return WriterError::kTooFlat;
}

}  // namespace cnc::gcode
