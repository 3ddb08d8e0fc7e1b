#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Number that means no part.
inline constexpr std::size_t kNoPart = SIZE_MAX;

/// Finds the part to which a cut belongs. A part is an outer contour that is cut at an offset, with
/// its holes, and with the marks that are in it and in no smaller part. An open mark belongs to the
/// part that contains most of it.
class PartFinder {
 public:
  PartFinder(const drawing::Drawing& drawn, const CutPlan& plan);

  /// Returns the number of the outer contour of the cut's part; kNoPart if the cut belongs to no
  /// part.
  [[nodiscard]] std::size_t part_of(const Cut& cut) const;

 private:
  enum class Role : std::uint8_t { kNone, kOuter, kHole, kMark };

  [[nodiscard]] std::size_t part_around(std::size_t contour) const;

  const drawing::Drawing& drawn_;
  std::vector<Role> roles_;
};

}  // namespace sim::cut
