#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "host-sim/contour/arrangement.hpp"
#include "host-sim/import/touching.hpp"

namespace sim::drawing {

/// Sorts the loops of an arrangement into sets. A loop that is simple, and at most touches other
/// loops, is a set by itself. Other loops are united with the loops that they overlap.
///
/// A loop overlaps itself if it crosses itself or runs along itself. Two loops overlap if one of
/// them has edges both inside and outside the other loop. They also overlap if they run along each
/// other and their insides are on the same side.
class Overlaps {
 public:
  Overlaps(const Arrangement& arrangement, std::size_t loops);

  /// Returns whether a loop overlaps itself or another loop.
  [[nodiscard]] bool overlaps(std::size_t loop) const { return overlaps_[loop]; }
  /// Returns the number of the set of a loop, which is the smallest number of a loop in this set.
  [[nodiscard]] std::size_t set_of(std::size_t loop) { return sets_.find(loop); }

 private:
  struct Relation {
    std::size_t edges_within = 0;  ///< Number of edges of the first loop within the second loop.
    std::size_t edges_on = 0;      ///< Number of edges that belong to both loops.
    /// True if the insides of both loops are on the same side of at least one shared edge.
    bool on_same_side = false;
  };
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  void add_edge(const Arrangement& arrangement, const ArrangedEdge& edge);
  void add_self(const EdgeOwner& owner, const Windings& left, const Windings& right);
  void conclude();
  void mark(std::uint32_t a, std::uint32_t b);

  std::vector<std::size_t> edges_;  ///< Number of edges of each loop.
  /// Winding number of each loop around its inside; 0 if it is not known yet.
  std::vector<int> turns_;
  std::vector<bool> overlaps_;
  PieceSets sets_;
  std::map<Pair, Relation> relations_;
};

}  // namespace sim::drawing
