#pragma once

#include <cstdint>
#include <span>

#include "planner/order/problem.hpp"

namespace cnc::order {

/// Rearrangements of the two neighbouring stretches B and C of a tour A B C, in which three legs of
/// the tour change. B⁻ is B in reverse.
enum class Rearrangement : std::uint8_t {
  kSwap,               ///< A C B
  kSwapReverseFirst,   ///< A C B⁻
  kSwapReverseSecond,  ///< A C⁻ B
  kReverseBoth,        ///< A B⁻ C⁻
};

struct TourSizes {
  std::size_t sets;
  std::size_t changes;
};

/// A change of a tour, with the data that are required to undo it.
struct Change {
  enum class Kind : std::uint8_t { kReverse, kSwap, kChoose };
  Kind kind;
  Index a;
  Index b;
  Index c;
};

/// Storage of a Tour.
struct TourSpace {
  std::span<Index> order;
  std::span<Index> positions;
  std::span<Index> chosen;
  std::span<Index> buffer;
  std::span<Change> changes;

  template <typename Layout>
  void lay_out(Layout& layout, const TourSizes& sizes) {
    layout(order, sizes.sets);
    layout(positions, sizes.sets);
    layout(chosen, sizes.sets);
    layout(buffer, sizes.sets);
    layout(changes, sizes.changes);
  }
};

/// A cyclic order of sets with a chosen candidate for each set, and a journal of the changes.
///
/// A stretch is given by its first position and its length. It may extend across the end of the
/// order to its beginning. A set that is reversed takes the candidate of the other direction.
class Tour {
 public:
  Tour(const Problem& problem, const TourSpace& space) : problem_{&problem}, space_{space} {}

  [[nodiscard]] Index size() const { return static_cast<Index>(space_.order.size()); }
  [[nodiscard]] Index at(Index position) const { return space_.order[position]; }
  [[nodiscard]] Index position_of(Index set) const { return space_.positions[set]; }
  [[nodiscard]] Index chosen(Index set) const { return space_.chosen[set]; }
  [[nodiscard]] std::span<const Index> order() const { return space_.order; }
  [[nodiscard]] std::span<const Index> choices() const { return space_.chosen; }
  [[nodiscard]] Index position_after(Index position) const {
    return position + 1 == size() ? 0 : position + 1;
  }
  [[nodiscard]] Index position_before(Index position) const {
    return position == 0 ? size() - 1 : position - 1;
  }
  [[nodiscard]] Index after(Index set) const { return at(position_after(position_of(set))); }
  [[nodiscard]] Index before(Index set) const { return at(position_before(position_of(set))); }

  /// Replaces order and choices, and clears the journal.
  void assign(std::span<const Index> order, std::span<const Index> chosen);
  /// Rotates the order so that home is at position 0. First reverses the order if home was
  /// reversed.
  void bring_home(Index home_candidate);

  void choose(Index set, Index candidate);
  void reverse(Index start, Index length);
  void swap(Index start, Index first_length, Index second_length);
  void rearrange(Rearrangement how, Index start, Index first_length, Index second_length);

  [[nodiscard]] bool can_note(std::size_t more) const {
    return noted_ + more <= space_.changes.size();
  }
  void forget_changes() { noted_ = 0; }
  void take_back_changes();

 private:
  void note(const Change& change) {
    if (noted_ < space_.changes.size()) space_.changes[noted_] = change;
    ++noted_;
  }
  [[nodiscard]] Index wrapped(Index position) const {
    return position >= size() ? position - size() : position;
  }
  void place(Index position, Index set) const {
    space_.order[position] = set;
    space_.positions[set] = position;
  }
  void turn_round(Index set) { space_.chosen[set] = problem_->reversal_of(space_.chosen[set]); }
  void move_reversed(Index start, Index length);
  void move_swapped(Index start, Index first_length, Index second_length);
  void shift_down(Index from, Index length, Index by);
  void shift_up(Index from, Index length, Index by);

  const Problem* problem_;
  TourSpace space_;
  std::size_t noted_ = 0;
};

}  // namespace cnc::order
