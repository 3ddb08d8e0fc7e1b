#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "host-sim/contour/arrangement.hpp"
#include "host-sim/import/touching.hpp"

namespace sim::drawing {

/// Sorts the loops of an arrangement. Loops that are simple, and at most touch other loops, stay by
/// themselves. All other loops are united to sets that overlap.
///
/// A loop overlaps itself if it crosses itself or runs along itself. Two loops overlap if one has
/// edges inside and outside the other, or if they run along each other with both insides on the
/// same side.
class Overlaps {
 public:
  Overlaps(const Arrangement& arrangement, std::size_t loops);

  /// Returns whether a loop overlaps itself or another loop.
  [[nodiscard]] bool overlaps(std::size_t loop) const { return overlaps_[loop]; }
  /// Returns the number of the set of a loop: the smallest number of the loops with which the loop
  /// must be resolved, itself included.
  [[nodiscard]] std::size_t set_of(std::size_t loop) { return sets_.find(loop); }

 private:
  struct Relation {
    std::size_t edges_within = 0;  ///< Number of edges of the first loop within the second loop.
    std::size_t edges_on = 0;      ///< Number of edges that belong to both loops.
    /// At one of the shared edges or more, both insides are on the same side.
    bool on_same_side = false;
  };
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  void add_edge(const Arrangement& arrangement, const ArrangedEdge& edge);
  void add_self(const EdgeOwner& owner, const Windings& left, const Windings& right);
  void conclude();
  void mark(std::uint32_t a, std::uint32_t b);

  std::vector<std::size_t> edges_;  ///< Number of edges of each loop.
  std::vector<int> turns_;          ///< Turns of each loop around its inside; 0: not known yet.
  std::vector<bool> overlaps_;
  PieceSets sets_;
  std::map<Pair, Relation> relations_;
};

}  // namespace sim::drawing
