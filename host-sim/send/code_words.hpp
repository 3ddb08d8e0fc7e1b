#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace sim {

/// The remedy for an alarm or an error of the firmware. The description is in cnc::alarm_texts()
/// and cnc::error_texts().
struct CodeRemedy {
  std::uint8_t number;
  std::string_view remedy;  ///< One or two sentences for the operator.
};

/// Return one entry for each alarm number, or for each error number, of the firmware.
[[nodiscard]] std::span<const CodeRemedy> alarm_remedies();
[[nodiscard]] std::span<const CodeRemedy> error_remedies();

/// Return the description and the remedy of a number. The result is empty for a number that the
/// firmware does not have but another controller may.
[[nodiscard]] std::string alarm_words(std::uint32_t number);
[[nodiscard]] std::string error_words(std::uint32_t number);
/// Returns the remedy without the description, for an error that the controller has explained
/// itself.
[[nodiscard]] std::string_view error_remedy(std::uint32_t number);

}  // namespace sim
