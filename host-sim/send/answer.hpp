#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sim {

enum class AnswerKind : std::uint8_t {
  kOther,
  kOk,       ///< `text` is what follows, in most controllers nothing.
  kError,    ///< `code`
  kAlarm,    ///< `code`
  kBanner,   ///< The controller has restarted.
  kStatus,   ///< `state`, and `waiting_room` where it says so.
  kOptions,  ///< `[OPT:`, with `waiting_room`.
  kMessage,  ///< `[MSG:`, its words in `text`.
  kResend,   ///< `number` is wanted; `line` says which was the last one taken.
};

/// The meaning of a line from a controller, Grbl's or Kerfline's, for a sender.
struct Answer {
  AnswerKind kind = AnswerKind::kOther;
  bool checked = false;  ///< Ended with its right CRC-32.
  std::uint32_t code = 0;
  std::uint32_t number = 0;
  std::optional<std::uint32_t> line{};          ///< Which line it is for: ` N12`.
  std::string state{};                          ///< `Hold:0` or the like.
  std::optional<std::uint32_t> waiting_room{};  ///< Bytes of lines that fit.
  bool moves = false;                           ///< A status with a feed that is not 0.
  std::string text{};
};

[[nodiscard]] Answer read_answer(std::string_view line);

/// `line*8D1F03A2`: with the CRC-32 of all before the star.
[[nodiscard]] std::string with_crc(std::string line);

}  // namespace sim
