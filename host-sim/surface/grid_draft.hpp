#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sim::surface {

/// A grid as it stands in a file, before it is checked. The height of a missing point is NaN; its
/// X and Y are always known.
struct GridDraft {
  std::string name;  ///< Name of the file, for messages.
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<Eigen::Vector3d> points{};  ///< Row by row, mm.
  /// Line of each point, from 1; 0 where the file has none. Empty for pictures.
  std::vector<std::uint32_t> lines{};
  std::vector<std::string> notes{};
  /// Height of the greatest over the least point that the operator wishes; 0: as the file says.
  double height_span_mm = 0.0;
  /// A drawn picture, in which a single high point is meant.
  bool is_picture = false;

  [[nodiscard]] Eigen::Vector3d& at(std::size_t row, std::size_t column) {
    return points[row * columns + column];
  }
  [[nodiscard]] const Eigen::Vector3d& at(std::size_t row, std::size_t column) const {
    return points[row * columns + column];
  }
  [[nodiscard]] bool is_missing(std::size_t index) const { return std::isnan(points[index].z()); }
};

/// Points of a grid that share a fault: their count, and the first of them.
class FaultyPoints {
 public:
  void add(std::size_t index) {
    if (count_ < first_.size()) first_[count_] = index;
    ++count_;
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Returns the index of the first one.
  /// @pre count() > 0
  [[nodiscard]] std::size_t first() const { return first_[0]; }
  /// Returns `row 2, column 3; row 4, column 5 and 7 more`, from 1 and in the order of the file. A
  /// point that no line of a text has is there with its X and Y.
  [[nodiscard]] std::string places(const GridDraft& grid) const;

 private:
  std::size_t count_ = 0;
  std::array<std::size_t, 3> first_{};
};

/// Throws the refusal of a grid for `faults`: `name:line: reason at places; remedy`.
/// @pre faults.count() > 0
[[noreturn]] void refuse_points(const GridDraft& grid,
                                const FaultyPoints& faults,
                                const std::string& reason,
                                const std::string& remedy);

}  // namespace sim::surface
