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
  std::vector<ContourVertex> vertices{};  ///< Without the row's end.
  const char* fault = nullptr;            ///< A literal; null if there are arcs.
  drawing::Place fault_place{0.0, 0.0};
};

/// A row of Bézier curves as seen from its start, in units of 2^-34 mm, with what else decides its
/// arcs.
///
/// The same row in different places of a drawing differs in its last binary digits. In these units
/// it is one row, and no coordinate of it moves by more than 0.03 nm.
class RowShape {
 public:
  /// Longer rows are hardly repeated, and large to keep.
  static constexpr std::size_t kMostCurves = 64;

  /// Returns nothing for curves of other kinds, for rows of more than kMostCurves, for those that
  /// are longer than a kilometre, and where a curve does not begin where the one before ends.
  /// @pre not empty
  [[nodiscard]] static std::optional<RowShape> of(std::span<const drawing::Shape> row);

  /// Appends a number that decides the arcs of the row as well: tolerance, method, ends.
  void add(std::int64_t number) { numbers_.push_back(number); }
  /// Returns the curves of the row, which begins at zero.
  [[nodiscard]] std::vector<drawing::Shape> curves() const;
  /// Returns how many numbers describe the row.
  [[nodiscard]] std::size_t size() const { return numbers_.size(); }

  [[nodiscard]] auto operator<=>(const RowShape&) const = default;

 private:
  std::size_t curves_ = 0;
  std::vector<std::int64_t> numbers_{};  ///< Three control points a curve, then the others.
};

/// Keeps the arcs of rows: generated drawings have few rounded corners, each of them many times.
/// One thread.
class KnownRows {
 public:
  /// Numbers that are kept, of shapes and of their arcs: 8 bytes each. A drawing that has more of
  /// them repeats none.
  static constexpr std::size_t kMostKept = 500'000;

  /// Returns the arcs of a shape, which begin at zero; valid until the next call.
  /// @param fit returns the arcs of a shape that is not kept; the shape alone must decide them
  template <typename Fit>
  [[nodiscard]] const FittedRow& find_or_fit(const RowShape& shape, const Fit& fit) {
    const auto known = rows_.find(shape);
    if (known != rows_.end()) return known->second;
    if (kept_ > kMostKept) forget();
    const FittedRow& fitted = rows_.emplace(shape, fit()).first->second;
    kept_ += shape.size() + kNumbersOfVertex * fitted.vertices.size();
    return fitted;
  }

  /// Returns how many numbers are kept; at most those of one row more than kMostKept.
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
