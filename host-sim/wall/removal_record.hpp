#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sim::wall {

/// Measured depths that a pass of a laser removes from a material, as a function of the energy per
/// mm of the path.
class RemovalRecord {
 public:
  /// Reads `{"passes": [{"power_w": P, "feed_mm_min": V, "depth_mm": D}, …]}` with at least two
  /// different energies P/V. Several passes with the same energy are replaced by their mean.
  /// @param name name of the file, for messages
  /// Throws std::invalid_argument for any other text.
  RemovalRecord(std::string_view json, const std::string& name);

  /// Returns the depth of a pass in mm, interpolated linearly between the two nearest energies.
  /// Throws std::invalid_argument for an energy outside the measured range.
  [[nodiscard]] double depth_of_pass(double power_w, double feed_mm_min) const;

 private:
  std::string name_;
  /// Energy in J/mm and depth in mm, sorted by energy.
  std::vector<std::pair<double, double>> depths_;
};

}  // namespace sim::wall
