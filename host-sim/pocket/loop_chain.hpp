#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"

namespace sim::pocket {

/// One loop of one pass.
struct PassLoop {
  std::uint32_t pass = 0;
  std::size_t loop = 0;
};

/// Tree of the passes of a pocket. Each pass lies within its parent.
class PassTree {
 public:
  /// @param parents for each pass, the number of the pass around it, which is smaller than its own;
  /// contour::kNone for passes at walls
  /// Both arguments must outlive the tree.
  PassTree(const std::vector<Contour>& passes, const std::vector<std::uint32_t>& parents);

  [[nodiscard]] std::uint32_t parent(std::uint32_t pass) const { return parents_[pass]; }
  /// Returns the numbers of all passes. Each pass comes directly after all passes within it.
  [[nodiscard]] const std::vector<std::uint32_t>& inner_first() const { return inner_first_; }

  /// Returns the pass directly within `pass`, if there is exactly one.
  [[nodiscard]] std::optional<std::uint32_t> only_child(std::uint32_t pass) const;
  /// Returns `pass` and all passes within it.
  [[nodiscard]] std::vector<std::uint32_t> within(std::uint32_t pass) const;

  /// Returns the loop around `inner` if only a ring is between the two loops. This requires that
  /// the outer pass has exactly one pass within it, and that both passes have the same number of
  /// loops. Returns none if the outer pass is at the wall, because wall passes are driven as full
  /// loops.
  [[nodiscard]] std::optional<PassLoop> around(const PassLoop& inner) const;

 private:
  const std::vector<Contour>& passes_;
  const std::vector<std::uint32_t>& parents_;
  std::vector<std::vector<std::uint32_t>> children_;
  std::vector<std::uint32_t> inner_first_;
};

}  // namespace sim::pocket
