#include "host-sim/import/overlaps.hpp"

#include <algorithm>
#include <span>

namespace sim::drawing {
namespace {

int turns_of(const Windings& windings, std::uint32_t loop) {
  const auto at = std::ranges::lower_bound(windings, loop, {}, &LoopTurns::loop);
  return at != windings.end() && at->loop == loop ? at->turns : 0;
}

bool has(std::span<const EdgeOwner> owners, std::uint32_t loop) {
  return std::ranges::any_of(owners, [loop](const EdgeOwner& owner) { return owner.loop == loop; });
}

}  // namespace

Overlaps::Overlaps(const Arrangement& arrangement, std::size_t loops)
    : edges_(loops, 0), turns_(loops, 0), overlaps_(loops, false), sets_{loops} {
  for (const ArrangedEdge& edge : arrangement.edges()) add_edge(arrangement, edge);
  conclude();
}

void Overlaps::add_edge(const Arrangement& arrangement, const ArrangedEdge& edge) {
  const auto owners = arrangement.owners(edge);
  const Windings& left = arrangement.windings(edge.left);
  const Windings& right = arrangement.windings(edge.right);
  for (const EdgeOwner& owner : owners) {
    ++edges_[owner.loop];
    add_self(owner, left, right);
    for (const LoopTurns& other : left) {
      if (!has(owners, other.loop)) ++relations_[{owner.loop, other.loop}].edges_within;
    }
    for (const EdgeOwner& other : owners) {
      if (other.loop == owner.loop) continue;
      Relation& relation = relations_[{owner.loop, other.loop}];
      ++relation.edges_on;
      const auto same_at = [&](const Windings& windings) {
        return (turns_of(windings, owner.loop) != 0) == (turns_of(windings, other.loop) != 0);
      };
      if (same_at(left) && same_at(right)) relation.on_same_side = true;
    }
  }
}

/// Marks the loop of an edge if it overlaps itself. A simple loop has no edge twice, and winds
/// exactly once around each point inside it, always in the same direction.
void Overlaps::add_self(const EdgeOwner& owner, const Windings& left, const Windings& right) {
  if (owner.along + owner.against > 1) mark(owner.loop, owner.loop);
  for (const Windings* windings : {&left, &right}) {
    const int turns = turns_of(*windings, owner.loop);
    if (turns == 0) continue;
    if (turns_[owner.loop] == 0) turns_[owner.loop] = turns;
    if (turns != turns_[owner.loop] || std::abs(turns) > 1) mark(owner.loop, owner.loop);
  }
}

void Overlaps::conclude() {
  for (const auto& [pair, relation] : relations_) {
    const auto [loop, other] = pair;
    const bool is_within = relation.edges_within != 0;
    const bool is_beside = relation.edges_within + relation.edges_on < edges_[loop];
    if (relation.on_same_side || (is_within && (is_beside || relation.edges_on != 0))) {
      mark(loop, other);
    }
  }
}

void Overlaps::mark(std::uint32_t a, std::uint32_t b) {
  overlaps_[a] = overlaps_[b] = true;
  sets_.unite(a, b);
}

}  // namespace sim::drawing
