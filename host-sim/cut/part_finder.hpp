#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Number of a part that is none.
inline constexpr std::size_t kNoPart = SIZE_MAX;

/// Finds the part that a cut belongs to. A part is an outer contour that is cut beside its line,
/// with its holes, and with the marks that lie in it but in no smaller part.
class PartFinder {
 public:
  PartFinder(const drawing::Drawing& drawn, const CutPlan& plan);

  /// Returns the outer contour of the part, or kNoPart.
  [[nodiscard]] std::size_t part_of(const Cut& cut) const;

 private:
  enum class Role : std::uint8_t { kNone, kOuter, kHole, kMark };

  /// What an outer contour encloses.
  struct Outer {
    std::size_t contour = 0;
    std::vector<Place> outline{};  ///< Closed: the last place is the first.
    Place low{0.0, 0.0};           ///< Corners of the box around it.
    Place high{0.0, 0.0};
  };

  [[nodiscard]] std::size_t part_around(std::size_t contour) const;
  [[nodiscard]] std::size_t part_at(const Place& place) const;
  [[nodiscard]] static bool encloses(const Outer& outer, const Place& place);
  void add_outers();

  const drawing::Drawing& drawn_;
  std::vector<Role> roles_;
  std::vector<Outer> outers_;  ///< By area, the smallest first; only where there are open marks.
};

}  // namespace sim::cut
