#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <vector>

#include "tests/target/machine/can_filters.hpp"
#include "tests/target/machine/can_frame.hpp"
#include "tests/target/machine/options.hpp"
#include "tests/target/machine/peripheral.hpp"
#include "tests/target/machine/random.hpp"

namespace machine {

/// Model of CAN1 (RM0090, 32) on a bus whose other nodes acknowledge and send the frames of a file.
/// It has modes with their handshakes, three mailboxes, two FIFOs of three frames, filters, exact
/// lengths of frames, error counters by ISO 11898-1, bus-off and both ways out of it. A corrupted
/// frame ends in an error at a random bit.
///
/// Not modelled: time stamps, wake-up by the bus, CAN2, traffic of other nodes during the wait
/// after bus-off.
class Can final : public Peripheral {
 public:
  Can(const Services& services, const Options& options, const std::vector<TimedFrame>& others);
  Can(const Can&) = delete;
  Can& operator=(const Can&) = delete;
  ~Can();

  void reset() override;
  void flush() const;

 private:
  static constexpr unsigned kMailboxes = 3, kFifos = 2;
  static constexpr std::size_t kDepth = 3;
  enum class Mode : std::uint8_t { kSleep, kInitialisation, kJoining, kNormal };
  enum class Sender : std::uint8_t { kNobody, kMailbox, kOther };
  using Mail = std::array<std::uint32_t, 4>;
  struct Fifo {
    std::deque<Mail> mails;
    std::uint32_t flags = 0;  // FULL, FOVR
  };

  [[nodiscard]] std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void write_master(std::uint32_t value);
  void write_transmit_status(std::uint32_t value);
  void write_fifo(Fifo& fifo, std::uint32_t value);
  void write_mailbox(unsigned index, std::uint32_t word, std::uint32_t value);
  [[nodiscard]] std::uint32_t master_status() const;
  [[nodiscard]] std::uint32_t transmit_status() const;
  [[nodiscard]] std::uint32_t error_status() const;
  [[nodiscard]] std::uint32_t error_flags() const;

  void change_mode();
  void joined();
  [[nodiscard]] std::int64_t bits_ns(std::uint64_t bits) const;
  [[nodiscard]] bool on_bus() const { return mode_ == Mode::kNormal && !bus_off_; }
  [[nodiscard]] bool pending(unsigned mailbox) const { return (mailboxes_[mailbox][0] & 1U) != 0; }
  [[nodiscard]] CanFrame frame_in(unsigned mailbox) const;
  [[nodiscard]] int next_mailbox() const;
  void contend();
  void begin(Sender sender, const CanFrame& frame);
  void over();
  void finish_own();
  void finish_other();
  void answer_request(unsigned mailbox, std::uint32_t result);
  void receive(const CanFrame& frame);
  void count_error(std::uint32_t code, bool sending);
  void raise_errors(std::uint32_t before);
  void go_bus_off();
  void recover();
  void settle();

  const Options& options_;
  const std::vector<TimedFrame>& others_;
  std::size_t next_other_ = 0;
  std::FILE* output_ = nullptr;
  Random random_;
  CanFilters filters_;
  InterruptLine transmit_line_, fifo0_line_, fifo1_line_, status_line_;
  Alarm bus_, join_, recovery_;

  std::uint32_t master_ = 0, interrupts_ = 0, timing_ = 0, results_ = 0;
  bool error_interrupt_ = false;
  Mode mode_ = Mode::kSleep;
  std::array<Mail, kMailboxes> mailboxes_{};
  std::array<std::uint64_t, kMailboxes> requested_{};  // Sequence number of each mailbox's request.
  std::uint64_t requests_ = 0;
  std::array<Fifo, kFifos> fifos_;

  Sender sender_ = Sender::kNobody;
  unsigned sending_ = 0;
  std::uint32_t failure_ = 0;  // Value of LEC with which this transfer ends.
  std::uint32_t transmit_errors_ = 0, receive_errors_ = 0, last_error_ = 0;
  bool bus_off_ = false;
};

}  // namespace machine
