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

/// Arcs of a row of curves, or the reason why there are none.
struct FittedRow {
  std::vector<ContourVertex> vertices{};  ///< Vertices without the end of the row.
  const char* fault = nullptr;            ///< Reason as a string literal; null if there are arcs.
  drawing::Place fault_place{0.0, 0.0};
};

/// A row of Bézier curves relative to its start, in units of 2^-34 mm, together with the other
/// numbers that decide its arcs.
///
/// The same row at different points of a drawing differs in its last binary digits. In these units
/// it is always the same row, and no coordinate moves by more than 0.03 nm.
class RowShape {
 public:
  /// Greatest number of curves. Longer rows are rarely repeated, and they take much memory.
  static constexpr std::size_t kMaxCurves = 64;

  /// Returns the shape of a row. Returns nothing for curves that are not Bézier curves, for more
  /// than kMaxCurves curves, and for a row longer than a kilometre. Returns nothing, too, if a
  /// curve does not begin where the previous one ends.
  /// @pre the row is not empty
  [[nodiscard]] static std::optional<RowShape> of(std::span<const drawing::Shape> row);

  /// Appends another number that decides the arcs of the row: tolerance, method or ends.
  void add(std::int64_t number) { numbers_.push_back(number); }
  /// Returns the curves of the row, moved so that they begin at the origin.
  [[nodiscard]] std::vector<drawing::Shape> curves() const;
  /// Returns how many numbers describe the row.
  [[nodiscard]] std::size_t size() const { return numbers_.size(); }

  [[nodiscard]] auto operator<=>(const RowShape&) const = default;

 private:
  std::size_t curves_ = 0;
  /// Three control points for each curve, then the numbers from add().
  std::vector<std::int64_t> numbers_{};
};

/// Keeps the arcs of rows, because generated drawings repeat a few rounded corners many times. For
/// use in one thread.
class KnownRows {
 public:
  /// Greatest count of numbers that are kept, 8 bytes each, for shapes and their arcs. When there
  /// are more, all of them are dropped.
  static constexpr std::size_t kMaxKept = 500'000;

  /// Returns the arcs of a shape, which begin at the origin. The reference is valid until the next
  /// call.
  /// @param fit returns the arcs of a shape that is not kept; the shape alone must decide them
  template <typename Fit>
  [[nodiscard]] const FittedRow& find_or_fit(const RowShape& shape, const Fit& fit) {
    const auto known = rows_.find(shape);
    if (known != rows_.end()) return known->second;
    if (kept_ > kMaxKept) forget();
    const FittedRow& fitted = rows_.emplace(shape, fit()).first->second;
    kept_ += shape.size() + kNumbersOfVertex * fitted.vertices.size();
    return fitted;
  }

  /// Returns how many numbers are kept: at most kMaxKept plus the numbers of one row.
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
