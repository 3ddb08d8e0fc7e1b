#include "host-sim/cut/cut_turn.hpp"

#include <map>

namespace sim::cut {

CutTurn wished_turn(const UnbegunCut& cut, Grouping grouping) {
  const bool by_layer = grouping == Grouping::kLayer;
  return {cut.settings.rank.value_or(0), cut.part_turn, by_layer ? cut.layer : 0};
}

std::vector<CutTurn> turns_of(const std::vector<UnbegunCut>& cuts, Grouping grouping) {
  std::vector<CutTurn> turns;
  turns.reserve(cuts.size());
  for (const UnbegunCut& cut : cuts) turns.push_back(wished_turn(cut, grouping));
  // Raises turns along chains of cuts until no turn changes. So the result does not depend on the
  // order of the cuts in the drawing.
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      for (const std::size_t before : cuts[i].after) {
        if (turns[before] <= turns[i]) continue;
        turns[i] = turns[before];
        is_changed = true;
      }
    }
  }
  return turns;
}

std::vector<std::size_t> numbered(const std::vector<CutTurn>& turns) {
  std::map<CutTurn, std::size_t> number_of;
  for (const CutTurn& turn : turns) number_of.emplace(turn, 0);
  std::size_t next = 0;
  for (auto& [turn, number] : number_of) number = next++;
  std::vector<std::size_t> numbers;
  numbers.reserve(turns.size());
  for (const CutTurn& turn : turns) numbers.push_back(number_of.at(turn));
  return numbers;
}

}  // namespace sim::cut
