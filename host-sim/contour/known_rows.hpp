#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/import/curve.hpp"

namespace sim {

/// The arcs that were fitted to a row of curves, or the reason why there are none.
struct FittedRow {
  /// Vertices at which the arcs begin; the end of the row is not included.
  std::vector<ContourVertex> vertices{};
  /// Reason why there are no arcs, as a string literal; null if there are arcs.
  const char* fault = nullptr;
  drawing::Place fault_place{0.0, 0.0};
};

/// The shape of a row of Bézier curves: its control points relative to its start, in units of 2^-34
/// mm, and the other numbers that determine its arcs.
///
/// If a row is repeated at different positions of a drawing, the last binary digits of its relative
/// coordinates differ. Rounded to these units, they are equal, and no coordinate moves by more than
/// 0.03 nm.
class RowShape {
 public:
  /// Greatest number of curves of a row. Longer rows are rarely repeated and would take much
  /// memory.
  static constexpr std::size_t kMaxCurves = 64;

  /// Returns the shape of a row. Returns nothing for curves that are not Bézier curves, for more
  /// than kMaxCurves curves, and for a row longer than a kilometre. Returns nothing, too, if a
  /// curve does not begin where the previous one ends.
  /// @pre the row is not empty
  [[nodiscard]] static std::optional<RowShape> of(std::span<const drawing::Shape> row);

  /// Appends another number that determines the arcs of the row: the tolerance, the method or a
  /// condition at an end.
  void add(std::int64_t number) { numbers_.push_back(number); }
  /// Returns the curves of the row, moved so that the row begins at the origin.
  [[nodiscard]] std::vector<drawing::Shape> curves() const;
  /// Returns the number of numbers that describe the row.
  [[nodiscard]] std::size_t size() const { return numbers_.size(); }

  [[nodiscard]] auto operator<=>(const RowShape&) const = default;

 private:
  std::size_t curves_ = 0;
  /// Coordinates of three control points for each curve, followed by the numbers from add().
  std::vector<std::int64_t> numbers_{};
};

/// Stores the arcs of rows for reuse, because generated drawings repeat a few rounded corners many
/// times. Must be used by one thread only.
class KnownRows {
 public:
  /// Greatest count of numbers that are stored for shapes and their arcs; each takes 8 bytes. If it
  /// is exceeded, all shapes and arcs are dropped.
  static constexpr std::size_t kMaxKept = 500'000;

  /// Returns the arcs of a row shape. The arcs begin at the origin. The reference is valid until
  /// the next call.
  /// @param fit function that returns the arcs of a shape which is not stored; the arcs must depend
  /// on the shape alone
  template <typename Fit>
  [[nodiscard]] const FittedRow& find_or_fit(const RowShape& shape, const Fit& fit) {
    const auto known = rows_.find(shape);
    if (known != rows_.end()) return known->second;
    if (kept_ > kMaxKept) forget();
    const FittedRow& fitted = rows_.emplace(shape, fit()).first->second;
    kept_ += shape.size() + kNumbersOfVertex * fitted.vertices.size();
    return fitted;
  }

  /// Returns the count of numbers that are stored, which is at most kMaxKept plus the numbers of
  /// one row.
  [[nodiscard]] std::size_t kept() const { return kept_; }

 private:
  static constexpr std::size_t kNumbersOfVertex = 3;

  void forget() {
    rows_.clear();
    kept_ = 0;
  }

  std::map<RowShape, FittedRow> rows_{};
  std::size_t kept_ = 0;
};

}  // namespace sim
