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

/// The conversation over one link, as in Grbl 1.1: one line in, one answer out, in order; realtime
/// bytes act in between.
///
/// `ok` is sent when the whole line is planned, or complete if it is a dwell, a probe or homing. So
/// a sender that waits for it never overruns the planner. No line is read before the answer to the
/// line before is on its way. A refused line is answered by `[MSG:column: reason]` and `error:N`
/// with Grbl's number.
///
/// If a sender checks its lines (LineCheck), missing lines are requested by `Resend: N`. With the
/// CRC the answers name their line, and carry a CRC as well: `ok N12*8D1F03A2`.
///
/// The protocol never waits for the link: answers are made line by line as the link takes them, a
/// status report before all others. No line except an acknowledgement contains "ok" or "error", in
/// any case, because senders would count it.
class LineProtocol {
 public:
  static constexpr std::size_t kLongestLine = gcode::kLongestLine;

  /// Gives the machine the content of the store.
  /// @param board may be null
  LineProtocol(hal::ByteStream& link,
               Machine& machine,
               hal::RecordStore& store,
               hal::ControlBoard* board);

  /// Reads and answers lines as far as that is possible without waiting.
  /// @param now microseconds
  void poll(hal::TickCount now);

  /// Returns whether poll() would send nothing and change nothing, if the link has no byte. A host
  /// that knows its link leaves out such polls, except one in each kMaxQuietUs.
  [[nodiscard]] bool is_quiet(hal::TickCount now) const;

  /// Handles a realtime byte that came apart from the stream. Its order relative to lines is
  /// unknown, so 0xA3, which depends on that order, is answered by a message.
  void act_at_once(std::byte byte);
  /// Returns the number of bytes of lines that can be received now.
  [[nodiscard]] std::uint32_t room() const { return receiver_.room(); }

  /// Returns whether every line must carry a number and a check.
  [[nodiscard]] bool checks_lines() const { return check_.strict(); }

  /// Begins another sender, which is greeted. It gets no answers to lines of the sender before, and
  /// those of them that are still unread are dropped.
  void begin_sender();

  /// Changes a setting and stores it, as a line would, for requests that come apart from the
  /// stream. Returns false if the machine is at work, the value is out of range or the store fails.
  [[nodiscard]] bool store_setting(std::uint16_t number, float value);

  /// Handles the loss of the sender when no other is there: motion and spindle stop as by the
  /// safety door. The position stays known, and the next sender may resume or reset.
  void lose_sender();

 private:
  /// End of the start-up lines. One more position follows the last line, to report its fault.
  static constexpr std::size_t kStartupDone = StoredState::kStartupLines + 1;
  /// Times that are measured from now_ and the last bytes wrap far later.
  static constexpr std::int32_t kMaxQuietUs = 1'000'000;

  /// Answer that the last line still waits for.
  enum class Owed : std::uint8_t { kNothing, kAck, kHoming };

  /// A start-up line that was stored and runs for the first time.
  struct StartupTrial {
    std::size_t index;
    StoredText before;    ///< The line that it replaces.
    bool failed = false;  ///< The line was refused, raised an alarm or was cut short by a reset.
  };

  // Main sequence, in line_protocol.cpp.
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

  // Lines that no line requested, in events.cpp.
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

  // `$`, in statements.cpp.
  void take_statement(std::string_view line);
  /// Not inlined, so that lines of G-code do not have its frame on the stack.
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

  // `$RESUME`, in progress_statements.cpp.
  void tell_progress();
  void reenter(const Statement& statement);
  void save_progress();

  // `$K`, in kerf_statements.cpp.
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
  /// @param number 0 for the fault's own number
  void refuse(const gcode::Fault& fault, std::uint32_t first_column, std::uint8_t number = 0);
  void acknowledge() { owed_ = Owed::kAck; }
  void message(std::string_view words);
  /// Returns space for the next line; answer() sends it. One line at a time.
  [[nodiscard]] Reply begin_answer() { return Reply{outbox_.room<Reply::kCapacity>()}; }
  /// Sends an acknowledgement, which names its line if lines are numbered.
  void answer_line(Reply& reply);
  void say_ok();
  void answer(const Reply& reply) { outbox_.wrote(reply.view().size()); }
  [[nodiscard]] bool inches() const;

  hal::ByteStream& link_;
  Machine& machine_;
  hal::ControlBoard* board_;
  StoredState stored_;
  KerfTables kerf_;
  std::uint32_t kerf_seen_ = 0;      ///< Revision when the machine was given a table.
  std::array<char, 64> incoming_{};  ///< Bytes of one read from the link.
  Receiver receiver_{};
  LineAssembler<kLongestLine> assembler_{};
  LineCheck check_{};
  SilenceWatch silence_{};
  Outbox<3 * Reply::kCapacity> outbox_{};  ///< Holds a message, a reason and its number.
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
  bool modes_wanted_ = false;  ///< 0x83: the parser state is to be sent between lines.
  bool beginning_ = true;      ///< After power-up or a reset: the banner is due.
  bool greeting_due_ = false;  ///< A new sender is to be greeted; nothing else changes.
  bool unheard_ = false;       ///< The sender of the line being done is gone.
  bool saving_failed_ = false;
  std::size_t startup_line_ = kStartupDone;  ///< Next start-up line to run.
  bool starts_ = false;                      ///< The lines done last were start-up lines.
  std::optional<StartupTrial> startup_trial_{};
};

}  // namespace cnc
