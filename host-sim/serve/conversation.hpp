#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/host/memory_store.hpp"
#include "host-sim/job/setting_line.hpp"

namespace sim {

/// Bytes that passed between sender and controller in one direction in one cycle.
struct Exchange {
  enum class Kind : char {
    kHeard = '>',   ///< The controller read the bytes.
    kSaid = '<',    ///< The controller wrote the bytes.
    kBeside = '^',  ///< Realtime bytes reached the controller outside the stream.
    kFull = '|',  ///< The controller had more bytes to write, but the link was full. Has no bytes.
    /// An emergency stop reached the controller over a bus, outside the stream. Has no bytes.
    kStop = '!',
  };
  Kind kind = Kind::kHeard;
  std::uint64_t time_ns = 0;  ///< Time of the exchange, by the clock of the controller.
  std::string bytes;
  /// Line of the exchange in the recording's file; 0 if it was not read from a file.
  std::size_t line = 0;
};

/// A surface that was probed.
struct ProbedSurface {
  double tip_mm = 0.0;  ///< Diameter of the probe's ball.
  std::string file;     ///< Content of the surface's file.
};

/// State of the controller and its machine at the start of a conversation.
struct ConversationSetting {
  std::vector<SettingChange> settings;
  double probe_plate_z_mm = 0.0;
  std::optional<ProbedSurface> probe_surface{};
  hal::host::MemoryStore::Records records;  ///< Records stored in the controller.
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
/// The line `probe_surface` is present if a surface is probed. It has the diameter of the tip in mm
/// and the bytes of the surface's file. `#` begins a comment line. Times are in nanoseconds of the
/// controller's time. They are whole cycles and never decrease.
struct Conversation {
  ConversationSetting setting;
  std::vector<Exchange> exchanges;
  std::uint64_t end_ns = 0;
};

/// Returns the lines before the exchanges.
[[nodiscard]] std::string head_text(const ConversationSetting& setting);
[[nodiscard]] std::string to_text(const Exchange& exchange);
/// Returns the line that ends the conversation.
[[nodiscard]] std::string end_text(std::uint64_t end_ns);
[[nodiscard]] std::string to_text(const Conversation& conversation);

/// Returns the conversation that `text` contains. Throws std::invalid_argument with `name:line: `
/// and the fault.
[[nodiscard]] Conversation parse_conversation(std::string_view text, const std::string& name);

}  // namespace sim
