#pragma once

#include <span>

#include "planner/order/completion_bound.hpp"

namespace cnc::order {

struct ExactSizes {
  std::size_t sets;
  std::size_t candidates;
  /// Number of states. A state consists of a collection of visited sets, and the set visited last.
  std::size_t states;
  std::size_t values;  ///< Number of costs. A state has a cost for each candidate of its last set.
};

/// Working storage of an Exact.
struct ExactSpace {
  struct State {
    SetMask visited;
    /// Index of the state's first cost. There is a cost for each candidate of `last`.
    std::size_t values;
    Index last;
  };

  CompletionBoundSpace bound;
  std::span<State> states;
  std::span<double> values;
  /// Index of the first state of each layer, and the end of the last layer. A layer consists of the
  /// states with the same number of visited sets.
  std::span<std::size_t> layers;
  std::span<Index> order;
  std::span<Index> chosen;

  template <typename Layout>
  void lay_out(Layout& layout, const ExactSizes& sizes) {
    bound.lay_out(layout, {sizes.sets, sizes.candidates});
    layout(states, sizes.states);
    layout(values, sizes.values);
    layout(layers, sizes.sets + 1);
    layout(order, sizes.sets);
    layout(chosen, sizes.sets);
  }
};

}  // namespace cnc::order
