#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// Who found something out, where and when.
struct Origin {
  bool is_measured_here = false;  ///< By a person on this machine; else taken over from elsewhere.
  std::string by{};               ///< Name of the person; empty: not known.
  std::string on{};               ///< YYYY-MM-DD; empty: not known.
  std::string source{};           ///< The file that it is from.
  bool operator==(const Origin&) const = default;
};

/// Power and speed at which an operation is done, without a law of the kerf. What is not known is
/// empty.
struct OperationRecord {
  std::string kind{};         ///< cut, fill or engrave.
  std::string description{};  ///< As the source has it.
  std::string laser{};        ///< Its name; empty: not named.
  std::optional<std::uint32_t> thickness_um{};
  std::optional<double> power_percent{};  ///< Of full power, above 0 to 100.
  std::optional<std::uint32_t> speed_um_min{};
  std::optional<std::uint32_t> passes{};
  std::optional<double> interval_mm{};  ///< From line to line of what is filled.
  std::optional<double> kerf_mm{};
  Origin origin{};
};

/// Returns `not measured here: from FILE of DATE`, or `measured by NAME on DATE, FILE`.
[[nodiscard]] std::string text_of(const Origin& origin);

/// Returns `cut, 3 mm: 65 percent, 600 mm/min, 2 passes, kerf not known`.
[[nodiscard]] std::string text_of(const OperationRecord& operation);

/// Returns the origins of operations, each once, as one text.
[[nodiscard]] std::string origins_of(const std::vector<OperationRecord>& operations);

/// Returns whether a text is a day of the calendar, YYYY-MM-DD.
[[nodiscard]] bool is_date(std::string_view text);

/// Asks for an operation of a material.
struct OperationWish {
  std::string material{};
  std::string kind{};
  std::uint32_t thickness_um = 0;
  std::string description{};  ///< Empty: any.
};

/// Returns the operation of that kind at that thickness, or of no known thickness where none is: of
/// those that were measured here the fastest with the least power, else the only one of the
/// description. Nothing where there is none. Throws std::invalid_argument naming the descriptions
/// where there are several, and the thicknesses where none fits.
[[nodiscard]] std::optional<OperationRecord> choose_operation(
    const std::vector<OperationRecord>& operations, const OperationWish& wish);

}  // namespace sim
