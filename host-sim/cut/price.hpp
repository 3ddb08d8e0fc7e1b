#pragma once

#include <string>

namespace sim::cut {

/// Prices that a job is reckoned by.
struct PriceList {
  double per_hour = 0.0;   ///< Of the machine, in `currency`.
  double per_sheet = 0.0;  ///< Of the material of the sheet, in `currency`.
  std::string currency{};  ///< `EUR`; printed behind each amount, may be empty.

  [[nodiscard]] bool is_given() const { return per_hour > 0.0 || per_sheet > 0.0; }
};

/// Returns an amount for people: two decimals, and the currency where it has one.
[[nodiscard]] std::string amount_text(double amount, const PriceList& prices);

/// What a job or a part of it costs, in the currency of the list.
struct Cost {
  double machine = 0.0;
  double material = 0.0;
  [[nodiscard]] double total() const { return machine + material; }
};

/// Returns the cost of a time on the machine and of a share of the sheet.
/// @param share 0…1
[[nodiscard]] Cost cost_of(const PriceList& prices, double seconds, double share);

}  // namespace sim::cut
