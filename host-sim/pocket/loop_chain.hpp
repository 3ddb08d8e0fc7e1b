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

/// Passes of a pocket by what is around them.
class PassTree {
 public:
  /// @param parents of each pass the one around it, which comes before it; contour::kNone at walls
  /// Both outlive the tree.
  PassTree(const std::vector<Contour>& passes, const std::vector<std::uint32_t>& parents);

  [[nodiscard]] std::uint32_t parent(std::uint32_t pass) const { return parents_[pass]; }
  /// Returns all passes, each behind those within it, with all within it in one row.
  [[nodiscard]] const std::vector<std::uint32_t>& inner_first() const { return inner_first_; }

  /// Returns the pass within another one, if there is one alone.
  [[nodiscard]] std::optional<std::uint32_t> only_child(std::uint32_t pass) const;
  /// Returns a pass and all that lie within it.
  [[nodiscard]] std::vector<std::uint32_t> within(std::uint32_t pass) const;

  /// Returns the loop around another one if a ring is between them and nothing else: the passes
  /// around have one pass within them, and as many loops. None for the pass at the wall, too, which
  /// is driven as a whole.
  [[nodiscard]] std::optional<PassLoop> around(const PassLoop& inner) const;

 private:
  const std::vector<Contour>& passes_;
  const std::vector<std::uint32_t>& parents_;
  std::vector<std::vector<std::uint32_t>> children_;
  std::vector<std::uint32_t> inner_first_;
};

}  // namespace sim::pocket
