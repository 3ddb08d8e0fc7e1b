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

/// A loop of a spiral, with the turns that lead to it.
struct SpiralLoop {
  PassLoop loop;
  cnc::pocket::Milling milling = cnc::pocket::Milling::kClimb;
  std::uint32_t turn_count = 1;  ///< Number of turns from the previous loop, if there is one.
  double start_mm = 0.0;  ///< Distance along the driven loop at which turns end and begin, mm.
  std::vector<WayElement> turns{};
};

/// A spiral around an island, from the pass at the island to the pass at the outer wall.
struct IslandSpiral {
  /// Number of the pass whose two loops are the first and the last loop of the spiral.
  std::uint32_t pass = 0;
  std::vector<SpiralLoop> loops;
  /// Numbers of all passes that the spiral replaces, including `pass`.
  std::vector<std::uint32_t> replaced;
};

/// For each loop of each pass, whether the loop is finished: driven already, or omitted.
using DrivenMarks = std::vector<std::vector<bool>>;

/// Searches for rows of loops that turns of a spiral can join. Each loop of a row is around the
/// previous loop.
class SpiralSearch {
 public:
  /// All three arguments must outlive the search.
  SpiralSearch(const PocketPlan& plan, const PassTree& tree, const SpiralOptions& options)
      : plan_{plan}, tree_{tree}, options_{options} {}

  [[nodiscard]] DrivenLoop driven(const PassLoop& loop, cnc::pocket::Milling milling) const {
    return {plan_.passes[loop.pass].view(), loop.loop, milling};
  }

  /// Returns the loops of the longest spiral outwards, from `first` up to the loops that are driven
  /// already. The result is empty if the spiral has fewer than two turns.
  [[nodiscard]] std::vector<SpiralLoop> outwards(const PassLoop& first,
                                                 const DrivenMarks& is_driven) const;

  /// Returns spirals around islands. Each outermost pass with a single hole has one, if the spiral
  /// is at most 1.5 times as long as the passes that it replaces. The stock is always on the outer
  /// side of the spiral. Therefore its first loop, at the island, is driven against the usual
  /// direction of loops at islands.
  [[nodiscard]] std::vector<IslandSpiral> around_islands() const;

 private:
  /// The two loops of a pass around one island.
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
