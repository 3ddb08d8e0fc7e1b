#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "firmware/link/line_assembler.hpp"
#include "firmware/link/line_check.hpp"
#include "firmware/link/outbox.hpp"
#include "firmware/link/receiver.hpp"
#include "firmware/link/silence_watch.hpp"
#include "firmware/machine/machine.hpp"
#include "firmware/protocol/listing.hpp"
#include "firmware/protocol/reply.hpp"
#include "firmware/protocol/sender_part.hpp"
#include "firmware/protocol/statement.hpp"
#include "firmware/protocol/status_report.hpp"
#include "firmware/store/kerf_tables.hpp"
#include "firmware/store/stored_state.hpp"
#include "hal/interface/byte_stream.hpp"
#include "hal/interface/control_board.hpp"
#include "hal/interface/record_store.hpp"
#include "hal/interface/tick_count.hpp"
#include "planner/gcode/line_reader.hpp"

namespace cnc {

/// The conversation with a sender over one link, as in Grbl 1.1: each line gets one answer, in
/// order. Realtime bytes act between lines and answers.
///
/// `ok` is sent after the complete line is planned. For a dwell, a probe or homing, `ok` is sent
/// after the action has ended. So a sender that waits for `ok` never overruns the planner. No line
/// is read before the answer to the previous line has been sent. A refused line is answered by
/// `[MSG:column: reason]` and `error:N` with Grbl's number.
///
/// If a sender checks its lines (LineCheck), missing lines are requested by `Resend: N`. With the
/// CRC, each answer contains the number of its line and a CRC: `ok N12*8D1F03A2`.
///
/// The protocol never waits for the link. It makes a line only after the link has taken the
/// previous line. If a status report is due, it is the next line. No line except an acknowledgement
/// contains "ok" or "error" in upper or lower case, because senders would count it as an
/// acknowledgement.
class LineProtocol {
 public:
  static constexpr std::size_t kLongestLine = gcode::kLongestLine;

  /// Passes the content of the store to the machine.
  /// @param board board for `$I+` and `$DFU`; may be null
  LineProtocol(hal::ByteStream& link,
               Machine& machine,
               hal::RecordStore& store,
               hal::ControlBoard* board);

  /// Reads and answers as many lines as are possible without waiting, up to a maximum number.
  /// @param now microseconds
  void poll(hal::TickCount now);

  /// Returns whether poll() would send nothing and change nothing if the link has no byte. A host
  /// that knows the state of its link may skip such polls, but must poll once in each kMaxQuietUs.
  [[nodiscard]] bool is_quiet(hal::TickCount now) const;

  /// Handles a realtime byte that arrived outside the stream. Its order relative to lines is
  /// unknown, so 0xA3, whose effect depends on that order, is answered by a message.
  void act_at_once(std::byte byte);
  /// Returns the number of bytes of lines that can be received now.
  [[nodiscard]] std::uint32_t room() const { return receiver_.room(); }

  /// Returns whether every line must have a number and a check.
  [[nodiscard]] bool checks_lines() const { return check_.strict(); }

  /// Restarts the protocol for a new sender and greets it. The new sender gets no answers to lines
  /// of the previous sender; unread lines of the previous sender are dropped.
  void begin_sender();

  /// Changes a setting and stores it, as a line `$number=value` does, for requests that arrive
  /// outside the stream. Returns false if the machine is busy, the value is out of range or the
  /// store fails.
  [[nodiscard]] bool store_setting(std::uint16_t number, float value);

  /// Handles the loss of the sender when no other sender is connected: stops motion and spindle as
  /// the safety door does. The position stays known, and the next sender may resume or reset.
  void lose_sender();

 private:
  /// Value of `startup_line_` after all start-up lines are done. The value before it,
  /// kStartupLines, is the step that reports a fault of the last start-up line.
  static constexpr std::size_t kStartupDone = StoredState::kStartupLines + 1;
  /// Longest time between two polls, microseconds. It is much shorter than the time in which ticks
  /// wrap, because poll() measures times since the last poll and the last bytes in ticks.
  static constexpr std::int32_t kMaxQuietUs = 1'000'000;

  /// Kind of the answer that is still owed for the last line.
  enum class Owed : std::uint8_t { kNothing, kAck, kHoming };

  /// A start-up line that was just stored and runs for the first time.
  struct StartupTrial {
    std::size_t index;
    StoredText before;    ///< Previous content of the start-up line.
    bool failed = false;  ///< The line was refused, raised an alarm or was interrupted by a reset.
  };

  // Functions of the main sequence, in line_protocol.cpp.
  void receive();
  void attend_realtime();
  void begin_anew();
  [[nodiscard]] bool finish_line();
  [[nodiscard]] bool read_line();
  [[nodiscard]] bool refuse_lost_line();
  [[nodiscard]] bool passes_check(std::string_view& line);
  void handle(std::string_view line);
  [[nodiscard]] gcode::Refusal accept(std::string_view line);
  void take_gcode(std::string_view line);
  void ask_again(LineCheck::Verdict verdict);
  void watch_checks();
  void watch_link();
  [[nodiscard]] bool waits_for_machine() const;
  [[nodiscard]] bool has_to_tell() const;
  [[nodiscard]] bool sender_owes() const;

  // A tool change, in tool_change.cpp.
  void acknowledge_tool();
  void refuse_tool();
  void forget_tool_change();
  void take_line_feed();
  [[nodiscard]] bool awaits_tool() const;
  [[nodiscard]] bool ends_tool_change(RealtimeByte command);
  void attend_tool_change();

  // Lines that no sender requested, in events.cpp.
  [[nodiscard]] bool report();
  [[nodiscard]] bool report_is_due() const;
  [[nodiscard]] bool tell_news();
  void tell_uncut(const Uncut& uncut);
  [[nodiscard]] bool tell_result();
  void welcome();
  void greet();
  void tell_trouble();
  void save_places();

  // Start-up lines, in startup_lines.cpp.
  void set_startup_line(const Statement& statement);
  [[nodiscard]] bool attend_startup_trial();
  void run_startup_line();
  void tell_startup_fault();

  // Statements (`$`), in statements.cpp.
  void take_statement(std::string_view line);
  /// Not inlined, so that its frame is not on the stack while a line of G-code is executed.
  [[gnu::noinline]] void take_command(const Statement& statement);
  void change_setting(const Statement& statement);
  void tell_waiting_limits();
  void refuse_setting(const Statement& statement, SettingError error);
  void jog(const Statement& statement);
  void home(const Statement& statement);
  void enter_boot_loader();
  void unlock();
  void toggle_check_mode();
  void restore(const Statement& statement);
  void set_user_text(const Statement& statement);
  void set_power_table(const Statement& statement);
  [[nodiscard]] bool rests() const;

  // Statements about the progress (`$RESUME`), in progress_statements.cpp.
  void tell_progress();
  void reenter(const Statement& statement);
  void save_progress();

  // Statements about kerf tables (`$K`), in kerf_statements.cpp.
  void take_kerf_statement(const Statement& statement);
  void refuse_kerf(const KerfTables::Trouble& trouble, std::uint16_t column);
  void write_kerf_part(const Statement& statement);
  void keep_kerf_table();
  void erase_kerf_table(const Statement& statement);
  void read_kerf_table(const Statement& statement);
  void ask_kerf(const Statement& statement);
  void select_kerf(std::uint32_t index);
  void load_settings();

  void refuse(std::uint8_t number, std::uint32_t column, std::string_view reason);
  [[nodiscard]] Reply begin_reason(std::uint32_t column);
  void refuse(std::uint8_t number, Reply& reason);
  void refuse(std::uint8_t number);
  void refuse(const compensation::Fault& fault);
  /// @param number number of the error; 0 for the number that belongs to the fault
  void refuse(const gcode::Fault& fault, std::uint32_t first_column, std::uint8_t number = 0);
  void acknowledge() { owed_ = Owed::kAck; }
  void message(std::string_view words);
  /// Returns space for the next line; answer() then sends the line. Only one line may be open.
  [[nodiscard]] Reply begin_answer() { return Reply{outbox_.room<Reply::kCapacity>()}; }
  /// Sends an acknowledgement; with the CRC it contains the number of its line.
  void answer_line(Reply& reply);
  void say_ok();
  void answer(const Reply& reply) { outbox_.wrote(reply.view().size()); }
  [[nodiscard]] bool inches() const;

  hal::ByteStream& link_;
  Machine& machine_;
  hal::ControlBoard* board_;
  StoredState stored_;
  KerfTables kerf_;
  /// Revision of the kerf tables when a table was last passed to the machine.
  std::uint32_t kerf_seen_ = 0;
  std::array<char, 64> incoming_{};  ///< Bytes that one call has read from the link.
  Receiver receiver_{};
  LineAssembler<kLongestLine> assembler_{};
  LineCheck check_{};
  SilenceWatch silence_{};
  /// Has space for a message, a reason and an error number.
  Outbox<3 * Reply::kCapacity> outbox_{};
  Listing listing_;
  StatusReport status_{};
  ReportForm form_{};
  Owed owed_ = Owed::kNothing;
  Alarm told_alarm_ = Alarm::kNone;
  bool tool_told_ = false;
  SenderPart sender_part_{};
  hal::TickCount now_{};
  hal::TickCount reported_{};  ///< Time of the last automatic report.
  bool auto_report_ = false;
  bool modes_wanted_ = false;  ///< The parser state (0x83) is to be sent between lines.
  bool beginning_ = true;      ///< The banner is due, after power-up or a reset.
  /// The banner for a new sender is due, without the other effects of a reset.
  bool greeting_due_ = false;
  /// The sender of the line in execution is gone, so the line gets no answer.
  bool unheard_ = false;
  bool saving_failed_ = false;
  std::size_t startup_line_ = kStartupDone;  ///< Index of the next start-up line to run.
  bool starts_ = false;                      ///< The last executed line was a start-up line.
  std::optional<StartupTrial> startup_trial_{};
};

}  // namespace cnc
