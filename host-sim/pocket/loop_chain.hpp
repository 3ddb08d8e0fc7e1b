#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"

namespace sim::pocket {

/// A loop of a pass.
struct PassLoop {
  std::uint32_t pass = 0;
  std::size_t loop = 0;
};

/// Tree of the passes of a pocket: each pass lies within its parent.
class PassTree {
 public:
  /// @param parents for each pass, the pass around it, which has a smaller number; contour::kNone
  /// at walls
  /// Both arguments must outlive the tree.
  PassTree(const std::vector<Contour>& passes, const std::vector<std::uint32_t>& parents);

  [[nodiscard]] std::uint32_t parent(std::uint32_t pass) const { return parents_[pass]; }
  /// Returns all passes. Each comes directly after all passes within it.
  [[nodiscard]] const std::vector<std::uint32_t>& inner_first() const { return inner_first_; }

  /// Returns the pass within another pass, if there is exactly one.
  [[nodiscard]] std::optional<std::uint32_t> only_child(std::uint32_t pass) const;
  /// Returns a pass and all passes within it.
  [[nodiscard]] std::vector<std::uint32_t> within(std::uint32_t pass) const;

  /// Returns the loop around another loop if nothing but a ring is between them. For that, the pass
  /// around must have exactly one pass within it, with the same number of loops. Returns none for
  /// the pass at the wall, which is driven as a whole.
  [[nodiscard]] std::optional<PassLoop> around(const PassLoop& inner) const;

 private:
  const std::vector<Contour>& passes_;
  const std::vector<std::uint32_t>& parents_;
  std::vector<std::vector<std::uint32_t>> children_;
  std::vector<std::uint32_t> inner_first_;
};

}  // namespace sim::pocket
