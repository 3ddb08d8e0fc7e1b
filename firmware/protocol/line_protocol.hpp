#pragma once

#include <cstdint>
#include <string_view>

#include "firmware/link/line_assembler.hpp"
#include "firmware/link/outbox.hpp"
#include "firmware/machine/machine.hpp"
#include "firmware/protocol/reply.hpp"
#include "hal/interface/byte_stream.hpp"
#include "planner/gcode/line_reader.hpp"

namespace cnc {

/// The conversation over one link: a line in, one answer out, in order.
///
/// `ok` when all that the line asks for is planned (a dwell: over), so a sender
/// that waits for it never overruns the planner. No line is read before the
/// answer to the one before is on its way. A refused line is answered by
/// `[MSG:column: reason]` and `error:N` with Grbl's number. `$N=value` changes a
/// setting. Realtime bytes and the other `$` commands are not spoken yet: each
/// `$` line that is not a setting is refused with error 3.
class LineProtocol {
 public:
  static constexpr std::size_t kLongestLine = gcode::kLongestLine;

  LineProtocol(hal::ByteStream& link, Machine& machine) : link_{link}, machine_{machine} {}

  /// Reads and answers what it can without waiting.
  void poll();

 private:
  [[nodiscard]] bool read_line();
  void handle(std::string_view line);
  void set_from(std::string_view line);
  void refuse(std::uint32_t number, std::uint32_t column, std::string_view reason);
  void answer(const Reply& reply);

  hal::ByteStream& link_;
  Machine& machine_;
  LineAssembler<kLongestLine> assembler_{};
  Outbox<2 * Reply::kCapacity> outbox_{};  ///< A reason and its number.
  bool owes_answer_ = false;
};

}  // namespace cnc
