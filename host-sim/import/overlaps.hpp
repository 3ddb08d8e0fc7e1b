#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "host-sim/contour/arrangement.hpp"
#include "host-sim/import/touching.hpp"

namespace sim::drawing {

/// Sorts the loops of an arrangement into those that are simple and lie beside or within each
/// other, touching at most, and sets of those that do not.
///
/// A loop overlaps itself where it crosses itself or runs along itself. Two loops overlap where one
/// has edges within and without the other, or where they run along each other with both insides on
/// the same side.
class Overlaps {
 public:
  Overlaps(const Arrangement& arrangement, std::size_t loops);

  /// Whether a loop overlaps itself or another one.
  [[nodiscard]] bool overlaps(std::size_t loop) const { return overlaps_[loop]; }
  /// The least number of the loops with which a loop must be resolved, itself included.
  [[nodiscard]] std::size_t set_of(std::size_t loop) { return sets_.find(loop); }

 private:
  struct Relation {
    std::size_t edges_within = 0;  ///< Of the first loop, within the second one.
    std::size_t edges_on = 0;      ///< Of both.
    bool on_same_side = false;     ///< At some of these, their insides.
  };
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  void add_edge(const Arrangement& arrangement, const ArrangedEdge& edge);
  void add_self(const EdgeOwner& owner, const Windings& left, const Windings& right);
  void conclude();
  void mark(std::uint32_t a, std::uint32_t b);

  std::vector<std::size_t> edges_;  ///< By loop.
  std::vector<int> turns_;          ///< By loop: round its inside; 0: not known yet.
  std::vector<bool> overlaps_;
  PieceSets sets_;
  std::map<Pair, Relation> relations_;
};

}  // namespace sim::drawing
