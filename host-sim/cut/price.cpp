#include "host-sim/cut/price.hpp"

#include <fmt/format.h>

namespace sim::cut {

std::string amount_text(double amount, const PriceList& prices) {
  return fmt::format("{:.2f}{}{}", amount, prices.currency.empty() ? "" : " ", prices.currency);
}

Cost cost_of(const PriceList& prices, double seconds, double share) {
  constexpr double kSecondsPerHour = 3600.0;
  return {prices.per_hour * seconds / kSecondsPerHour, prices.per_sheet * share};
}

}  // namespace sim::cut
