#pragma once

#include <cstddef>
#include <cstdint>

#include "planner/contour/slice.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc::pocket {

/// The purpose of an element of a tool path.
enum class Use : std::uint8_t {
  kPass,   ///< Cuts: the tool removes stock along it.
  kLight,  ///< Cuts, with an engagement of at most the value that the caller allowed.
  kLink,   ///< Moves at depth, at the cutting feed, where there is no stock any more.
  /// A line or an arc back to the next cut at the same depth. Along lines the tool may move at the
  /// rapid rate, because it touches stock at most at the two ends.
  kReturn,
  kEntry,  ///< Descends into stock by a ramp or a helix.
  /// A line over cleared stock. A cutter compensation may begin at the start of the line.
  kLeadIn,
  kLeadOut,  ///< A line over cleared stock. The cutter compensation ends at the start of the line.
};

/// The start of an element of a tool path. The element is the arc or the line to the next point of
/// its row; z changes in proportion to the length. No element begins at the last point of a row.
template <typename Scalar>
struct PathPoint {
  Scalar x{};      ///< mm.
  Scalar y{};      ///< mm.
  Scalar z{};      ///< Height in mm; 0 is the top of the stock, negative values are below it.
  Scalar bulge{};  ///< Bulge tan(sweep / 4) in the plane; positive turns left, 0 is a line.
  Use use = Use::kPass;

  [[nodiscard]] BasicVec2<Scalar> point() const { return {x, y}; }
};

/// Rows of points in storage that the caller owns. The tool retracts between rows.
template <typename Scalar>
struct ToolPathView {
  contour::Slice<const PathPoint<Scalar>> points;
  /// End of each row: the index after its last point.
  contour::Slice<const std::uint32_t> row_ends;

  [[nodiscard]] std::uint32_t row_begin(std::size_t row) const {
    return row == 0 ? 0 : row_ends[row - 1];
  }
};

/// Writes rows into storage that the caller owns.
template <typename Scalar>
class ToolPathWriter {
 public:
  ToolPathWriter(contour::Slice<PathPoint<Scalar>> points, contour::Slice<std::uint32_t> row_ends)
      : points_{points}, row_ends_{row_ends} {}

  void clear() { point_count_ = row_count_ = 0; }
  /// Adds a point. Returns false and changes nothing if the storage is full.
  [[nodiscard]] bool add(const PathPoint<Scalar>& point) {
    if (point_count_ == points_.size()) return false;
    points_[point_count_++] = point;
    return true;
  }
  [[nodiscard]] bool end_row() {
    if (row_count_ == row_ends_.size()) return false;
    row_ends_[row_count_++] = static_cast<std::uint32_t>(point_count_);
    return true;
  }

  [[nodiscard]] std::size_t point_count() const { return point_count_; }
  [[nodiscard]] ToolPathView<Scalar> view() const {
    return {{points_.begin(), point_count_}, {row_ends_.begin(), row_count_}};
  }

 private:
  contour::Slice<PathPoint<Scalar>> points_;
  contour::Slice<std::uint32_t> row_ends_;
  std::size_t point_count_ = 0;
  std::size_t row_count_ = 0;
};

}  // namespace cnc::pocket
