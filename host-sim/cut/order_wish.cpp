#include "host-sim/cut/order_wish.hpp"

namespace sim::cut {

std::string_view text_of(OrderCost cost) { return cost == OrderCost::kTime ? "time" : "length"; }

std::string_view text_of(Grouping grouping) {
  switch (grouping) {
    case Grouping::kNone:
      return "none";
    case Grouping::kLayer:
      return "layer";
    case Grouping::kPart:
      return "part";
  }
  return "";
}

}  // namespace sim::cut
