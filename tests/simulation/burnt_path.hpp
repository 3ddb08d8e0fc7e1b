#pragma once

#include <cstddef>
#include <vector>

namespace proof {

/// An edge with the beam on: where the tool is, mm, and the output.
struct Burnt {
  double x = 0.0;
  double y = 0.0;
  double duty = 0.0;
};

/// The burn of a job that was not interrupted, with which others are compared.
class BurntPath {
 public:
  /// All 0 if nothing is missing, nothing burnt twice, and nothing beside the path.
  struct Gap {
    double twice_mm = 0.0;
    double left_mm = 0.0;
    double beside_mm = 0.0;
    int other_power = 0;  ///< Edges with an output that the whole does not have there.
  };

  explicit BurntPath(std::vector<Burnt> rows);

  /// Judges a burn of which the first `before` rows are those of this one.
  [[nodiscard]] Gap judge(const std::vector<Burnt>& burnt, std::size_t before) const;
  [[nodiscard]] bool empty() const { return rows_.empty(); }

 private:
  [[nodiscard]] std::size_t nearest(const Burnt& place, std::size_t near, double reach_mm) const;
  [[nodiscard]] bool burns_so(std::size_t row, double duty) const;

  std::vector<Burnt> rows_;
  std::vector<double> ways_;  ///< mm from the start, without rapids.
  std::vector<double> lit_;   ///< The same, without dark pixels.
};

}  // namespace proof
