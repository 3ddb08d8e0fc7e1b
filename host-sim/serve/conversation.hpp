#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/host/memory_store.hpp"
#include "host-sim/job/setting_line.hpp"

namespace sim {

/// Some bytes that passed between sender and controller in one turn.
struct Exchange {
  enum class Kind : char {
    kHeard = '>',   ///< The controller read them.
    kSaid = '<',    ///< The controller wrote them.
    kBeside = '^',  ///< Realtime bytes reached it apart from the stream.
    kFull = '|',    ///< It had more to write, but the link was full; no bytes.
    kStop = '!',    ///< An emergency stop came over a bus, apart from the stream; no bytes.
  };
  Kind kind = Kind::kHeard;
  std::uint64_t time_ns = 0;  ///< The controller's time.
  std::string bytes;
  std::size_t line = 0;  ///< Of the file it was read from; else 0.
};

/// A surface that was probed.
struct ProbedSurface {
  double tip_mm = 0.0;  ///< Diameter of the probe's ball.
  std::string file;     ///< Bytes of the surface's file.
};

/// The machine that a conversation is had with, as it was at the start.
struct ConversationSetting {
  std::vector<SettingChange> settings;
  double probe_plate_z_mm = 0.0;
  std::optional<ProbedSurface> probe_surface{};
  hal::host::MemoryStore::Records records;  ///< What was stored.
};

/// A conversation between a sender and the controller, kept as text:
///
///     kerfline conversation 1
///     probe_plate -10
///     probe_surface 2 "0 0 1\n"
///     set $110=12000
///     record 3 "\x00\x01"
///     > 120000000 "G0 X1\n"
///     ^ 121000000 "?"
///     < 121000000 "ok\r\n"
///     end 500000000
///
/// `probe_surface` is there if a surface is probed: the diameter of the tip, and the bytes of the
/// surface's file. `#` begins a comment line. Times are nanoseconds of the controller, whole
/// turns, and never go back.
struct Conversation {
  ConversationSetting setting;
  std::vector<Exchange> exchanges;
  std::uint64_t end_ns = 0;
};

/// The lines in front of the exchanges.
[[nodiscard]] std::string head_text(const ConversationSetting& setting);
[[nodiscard]] std::string to_text(const Exchange& exchange);
/// The line that ends the conversation.
[[nodiscard]] std::string end_text(std::uint64_t end_ns);
[[nodiscard]] std::string to_text(const Conversation& conversation);

/// Throws std::invalid_argument with `name:line: ` and what is wrong.
[[nodiscard]] Conversation parse_conversation(std::string_view text, const std::string& name);

}  // namespace sim
