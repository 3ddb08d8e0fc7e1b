#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// Origin of measured or imported values: the person, the day and the file.
struct Origin {
  /// Whether a person measured the values on this machine; otherwise they were imported.
  bool is_measured_here = false;
  std::string by{};      ///< Name of the person who measured; empty if not known.
  std::string on{};      ///< Day of the measurement or the import, YYYY-MM-DD; empty if not known.
  std::string source{};  ///< File from which the values were read.
  bool operator==(const Origin&) const = default;
};

/// Power and speed at which an operation is done, without a law of the kerf. Values that are not
/// known are empty.
struct OperationRecord {
  std::string kind{};         ///< Kind of the operation: cut, fill or engrave.
  std::string description{};  ///< Description in the source, unchanged.
  std::string laser{};        ///< Name of the laser; empty if not named.
  std::optional<std::uint32_t> thickness_um{};
  std::optional<double> power_percent{};  ///< Percent of full power, above 0 to 100.
  std::optional<std::uint32_t> speed_um_min{};
  std::optional<std::uint32_t> passes{};
  std::optional<double> interval_mm{};  ///< Distance between the lines of a fill.
  std::optional<double> kerf_mm{};
  Origin origin{};
};

/// Returns a text such as `not measured here: from FILE of DATE` or `measured by NAME on DATE,
/// FILE`.
[[nodiscard]] std::string text_of(const Origin& origin);

/// Returns a text such as `cut, 3 mm: 65 percent, 600 mm/min, 2 passes, kerf not known`.
[[nodiscard]] std::string text_of(const OperationRecord& operation);

/// Returns the origins of operations, each once, as one text.
[[nodiscard]] std::string origins_of(const std::vector<OperationRecord>& operations);

/// Returns whether a text is a day of the calendar, YYYY-MM-DD.
[[nodiscard]] bool is_date(std::string_view text);

/// Requirements for an operation of a material.
struct OperationWish {
  std::string material{};
  std::string kind{};
  std::uint32_t thickness_um = 0;
  std::string description{};  ///< Description of the operation; empty for any.
};

/// Returns one of the operations of the wished kind and thickness or, if none has this thickness,
/// of those without a known thickness. If any of them were measured here, returns the fastest
/// measured operation; of equally fast ones, that with the least power. Otherwise returns the only
/// operation with the wished description; empty if there is none. Throws std::invalid_argument
/// naming the descriptions if there are several, and the thicknesses if none fits.
[[nodiscard]] std::optional<OperationRecord> choose_operation(
    const std::vector<OperationRecord>& operations, const OperationWish& wish);

}  // namespace sim
