#pragma once

#include <cstddef>
#include <vector>

namespace proof {

/// A trace edge with the beam on: position of the tool, mm, and output.
struct Burnt {
  double x = 0.0;
  double y = 0.0;
  double duty = 0.0;
};

/// Burn of a job without interruptions, with which the burns of interrupted jobs are compared.
class BurntPath {
 public:
  /// Differences between two burns. All are 0 if nothing is missing, burnt twice or off the path.
  struct Gap {
    double twice_mm = 0.0;
    double left_mm = 0.0;
    double beside_mm = 0.0;
    /// Number of edges whose output differs from that of the uninterrupted job at the same point.
    int other_power = 0;
  };

  explicit BurntPath(std::vector<Burnt> rows);

  /// Compares a burn with this one; its first `before` rows are those before the interruption.
  [[nodiscard]] Gap judge(const std::vector<Burnt>& burnt, std::size_t before) const;
  [[nodiscard]] bool empty() const { return rows_.empty(); }

 private:
  [[nodiscard]] std::size_t nearest(const Burnt& place, std::size_t near, double reach_mm) const;
  [[nodiscard]] bool burns_so(std::size_t row, double duty) const;

  std::vector<Burnt> rows_;
  std::vector<double> ways_;  ///< Distance from the start, without rapids, mm.
  std::vector<double> lit_;   ///< Distance from the start, without rapids and dark pixels, mm.
};

}  // namespace proof
