#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace sim {

/// A symmetric positive definite system of equations whose matrix has two diagonals on either side
/// of the main one: each unknown depends only on the two before and the two after it.
class BandSystem {
 public:
  explicit BandSystem(std::size_t size) : diagonals_{}, right_(size) {
    for (auto& diagonal : diagonals_) diagonal.resize(size);
  }

  [[nodiscard]] std::size_t size() const { return right_.size(); }
  void clear();

  /// Adds `value` to the matrix element at (`row`, `row` + `beside`) and to its mirror image;
  /// `beside` is 0…2.
  void add(std::size_t row, std::size_t beside, double value) { diagonals_[beside][row] += value; }
  void add_right(std::size_t row, double value) { right_[row] += value; }
  [[nodiscard]] const std::vector<double>& right() const { return right_; }

  /// Returns the unknowns, by L D Lᵀ without pivoting. Overwrites the matrix. Where rounding makes
  /// a pivot zero or negative, its unknown is 0.
  [[nodiscard]] std::vector<double> solve();

 private:
  std::array<std::vector<double>, 3> diagonals_;
  std::vector<double> right_;
};

}  // namespace sim
