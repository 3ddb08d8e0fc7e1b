#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sim::wall {

/// How deep a pass of a laser cuts into a material, as measured: depth over the energy that each
/// millimetre of the line gets.
class RemovalRecord {
 public:
  /// Reads `{"passes": [{"power_w": P, "feed_mm_min": V, "depth_mm": D}, …]}` of at least two
  /// different energies P/V; passes of one energy count as their mean.
  /// @param name of the file, for messages. Throws std::invalid_argument for another text.
  RemovalRecord(std::string_view json, const std::string& name);

  /// Returns the depth of a pass, mm, on the straight line between the two nearest energies.
  /// Throws std::invalid_argument for an energy outside those that were measured.
  [[nodiscard]] double depth_of_pass(double power_w, double feed_mm_min) const;

 private:
  std::string name_;
  std::vector<std::pair<double, double>> depths_;  ///< J/mm and mm, by energy.
};

}  // namespace sim::wall
