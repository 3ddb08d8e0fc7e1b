#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host-sim/pocket/driven_loop.hpp"
#include "host-sim/pocket/loop_chain.hpp"
#include "host-sim/pocket/pocket_plan.hpp"
#include "host-sim/pocket/spiral_path.hpp"
#include "host-sim/pocket/spiral_turn.hpp"

namespace sim::pocket {

/// A loop of a spiral and the turns that lead to it.
struct SpiralLoop {
  PassLoop loop;
  cnc::pocket::Milling milling = cnc::pocket::Milling::kClimb;
  std::uint32_t turn_count = 1;  ///< From the loop before, if there is one.
  double start_mm = 0.0;         ///< Where turns end and begin, on the loop as it is driven.
  std::vector<WayElement> turns{};
};

/// A spiral around an island: from the pass beside it to the pass within the wall around.
struct IslandSpiral {
  std::uint32_t pass = 0;  ///< Whose two loops are the first and the last of the spiral.
  std::vector<SpiralLoop> loops;
  std::vector<std::uint32_t> replaced;  ///< All passes that need not be driven, `pass` among them.
};

/// Whether the loops of each pass are driven, or left out.
using DrivenMarks = std::vector<std::vector<bool>>;

/// Finds rows of loops, each around the one before it, that turns of a spiral join.
class SpiralSearch {
 public:
  /// All three outlive the search.
  SpiralSearch(const PocketPlan& plan, const PassTree& tree, const SpiralOptions& options)
      : plan_{plan}, tree_{tree}, options_{options} {}

  [[nodiscard]] DrivenLoop driven(const PassLoop& loop, cnc::pocket::Milling milling) const {
    return {plan_.passes[loop.pass].view(), loop.loop, milling};
  }

  /// Returns the loops of the longest spiral from a loop outwards, itself included, up to those
  /// that are driven already. Empty if it has fewer than two turns.
  [[nodiscard]] std::vector<SpiralLoop> outwards(const PassLoop& first,
                                                 const DrivenMarks& is_driven) const;

  /// Returns spirals around islands: one for each outermost pass with a single hole, if the spiral
  /// is at most half as long again as the passes that it replaces. Its stock is always on the outer
  /// side, so its first loop, at the island, is driven against the direction of loops at islands.
  [[nodiscard]] std::vector<IslandSpiral> around_islands() const;

 private:
  /// Both loops of a pass around one island.
  struct Ring {
    PassLoop island;
    PassLoop outline;
  };

  [[nodiscard]] std::size_t add_turns(std::vector<SpiralLoop>& spiral) const;
  [[nodiscard]] std::optional<IslandSpiral> around_island(std::uint32_t pass) const;
  [[nodiscard]] std::vector<Ring> rings_from(std::uint32_t pass) const;
  [[nodiscard]] std::uint32_t turns_between(const Ring& ring) const;
  [[nodiscard]] double length_of(const PassLoop& loop) const;
  [[nodiscard]] Contour only(const PassLoop& loop) const;

  const PocketPlan& plan_;
  const PassTree& tree_;
  const SpiralOptions& options_;
};

}  // namespace sim::pocket
