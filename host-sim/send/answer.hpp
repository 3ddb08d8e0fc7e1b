#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sim {

enum class AnswerKind : std::uint8_t {
  kOther,
  kOk,       ///< `text` is the rest of the line after `ok`; most controllers send none.
  kError,    ///< `code` is the number of the error.
  kAlarm,    ///< `code` is the number of the alarm.
  kBanner,   ///< The greeting of a controller that has started.
  kStatus,   ///< A status report: `state`, and `waiting_room` if the report has it.
  kOptions,  ///< The options, `[OPT:`, with `waiting_room`.
  kMessage,  ///< A message, `[MSG:`; `text` has its words.
  kResend,   ///< A request to send line `number` again; `line` is the last line that was accepted.
};

/// Content of a line from a controller (Grbl or Kerfline), as a sender interprets it.
struct Answer {
  AnswerKind kind = AnswerKind::kOther;
  bool checked = false;  ///< Whether the line ended with a correct CRC-32.
  std::uint32_t code = 0;
  std::uint32_t number = 0;
  std::optional<std::uint32_t> line{};          ///< Number of the answered line, from ` N12`.
  std::string state{};                          ///< State of the machine, such as `Hold:0`.
  std::optional<std::uint32_t> waiting_room{};  ///< Free space for lines, bytes.
  bool moves = false;  ///< Whether the status report has a feed that is not 0.
  std::string text{};
};

[[nodiscard]] Answer read_answer(std::string_view line);

/// Returns `line` with a star and its CRC-32 appended, such as `line*8D1F03A2`. The CRC-32 covers
/// all characters before the star.
[[nodiscard]] std::string with_crc(std::string line);

}  // namespace sim
