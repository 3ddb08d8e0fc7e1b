#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace sim {

/// A symmetric positive definite system of equations in which each unknown
/// meets only its two neighbours on either side.
class BandSystem {
 public:
  explicit BandSystem(std::size_t size) : diagonals_{}, right_(size) {
    for (auto& diagonal : diagonals_) diagonal.resize(size);
  }

  [[nodiscard]] std::size_t size() const { return right_.size(); }
  void clear();

  /// To the matrix at (row, row + beside), beside 0…2, and to its mirror image.
  void add(std::size_t row, std::size_t beside, double value) { diagonals_[beside][row] += value; }
  void add_right(std::size_t row, double value) { right_[row] += value; }
  [[nodiscard]] const std::vector<double>& right() const { return right_; }

  /// By L D Lᵀ without pivoting; the matrix is used up. Where rounding has left a
  /// pivot that is not positive, its unknown stays 0.
  [[nodiscard]] std::vector<double> solve();

 private:
  std::array<std::vector<double>, 3> diagonals_;
  std::vector<double> right_;
};

}  // namespace sim
