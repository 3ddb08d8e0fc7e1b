#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sim::surface {

/// A grid as read from a file, before checks. The height of a missing point is NaN; its X and Y are
/// always known.
struct GridDraft {
  std::string name;  ///< Name of the file, for messages.
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<Eigen::Vector3d> points{};  ///< Points row by row, mm.
  /// Line of each point in the file, counted from 1; 0 for a point that the file does not contain.
  /// Empty for pictures.
  std::vector<std::uint32_t> lines{};
  std::vector<std::string> notes{};
  /// Height of the highest point above the lowest point to which the heights are scaled; 0: heights
  /// as in the file.
  double height_span_mm = 0.0;
  /// Whether the grid is a drawn picture, in which a single high point is intended.
  bool is_picture = false;

  [[nodiscard]] Eigen::Vector3d& at(std::size_t row, std::size_t column) {
    return points[row * columns + column];
  }
  [[nodiscard]] const Eigen::Vector3d& at(std::size_t row, std::size_t column) const {
    return points[row * columns + column];
  }
  [[nodiscard]] bool is_missing(std::size_t index) const { return std::isnan(points[index].z()); }
};

/// Points of a grid with the same fault: their number, and the first few of these points.
class FaultyPoints {
 public:
  void add(std::size_t index) {
    if (count_ < first_.size()) first_[count_] = index;
    ++count_;
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Returns the index of the first faulty point.
  /// @pre count() > 0
  [[nodiscard]] std::size_t first() const { return first_[0]; }
  /// Returns the positions of the points as text, for example `row 2, column 3; row 4, column 5 and
  /// 7 more`. Rows and columns count from 1 in the order of the file. A point without a line in a
  /// text file is listed with its X and Y as well.
  [[nodiscard]] std::string places(const GridDraft& grid) const;

 private:
  std::size_t count_ = 0;
  std::array<std::size_t, 3> first_{};
};

/// Refuses a grid with `faults`: throws std::invalid_argument with `name:line: reason at places;
/// remedy`.
/// @pre faults.count() > 0
[[noreturn]] void refuse_points(const GridDraft& grid,
                                const FaultyPoints& faults,
                                const std::string& reason,
                                const std::string& remedy);

}  // namespace sim::surface
