#pragma once

#include <string>

namespace sim::cut {

/// Prices from which the cost of a job is computed.
struct PriceList {
  double per_hour = 0.0;   ///< Price of the machine per hour, in `currency`.
  double per_sheet = 0.0;  ///< Price of the material of a sheet, in `currency`.
  /// Currency, for example `EUR`, which follows each printed amount; may be empty.
  std::string currency{};

  [[nodiscard]] bool is_given() const { return per_hour > 0.0 || per_sheet > 0.0; }
};

/// Returns the text of an amount, with two decimals, and with the currency if the list has one.
[[nodiscard]] std::string amount_text(double amount, const PriceList& prices);

/// Cost of a job or of a part of it, in the currency of the list.
struct Cost {
  double machine = 0.0;
  double material = 0.0;
  [[nodiscard]] double total() const { return machine + material; }
};

/// Returns the cost of `seconds` on the machine and of a share of the sheet.
/// @param share 0…1
[[nodiscard]] Cost cost_of(const PriceList& prices, double seconds, double share);

}  // namespace sim::cut
