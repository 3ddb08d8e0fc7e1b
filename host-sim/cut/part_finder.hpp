#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Number of a part that is none.
inline constexpr std::size_t kNoPart = SIZE_MAX;

/// Finds the part that a cut belongs to. A part is an outer contour that is cut beside its line,
/// with its holes, and with the marks that lie in it but in no smaller part; an open mark is of the
/// part that has most of it.
class PartFinder {
 public:
  PartFinder(const drawing::Drawing& drawn, const CutPlan& plan);

  /// Returns the outer contour of the part, or kNoPart.
  [[nodiscard]] std::size_t part_of(const Cut& cut) const;

 private:
  enum class Role : std::uint8_t { kNone, kOuter, kHole, kMark };

  [[nodiscard]] std::size_t part_around(std::size_t contour) const;

  const drawing::Drawing& drawn_;
  std::vector<Role> roles_;
};

}  // namespace sim::cut
