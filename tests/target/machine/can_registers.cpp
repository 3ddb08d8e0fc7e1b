// Registers, handshakes and interrupts as the controller's driver sees them.

#include "tests/target/machine/can_registers.hpp"

#include "tests/target/machine/can.hpp"

namespace machine {

// NOLINT(google-build-using-namespace): this file uses these names throughout.
using namespace can_registers;

void Can::reset() {
  for (Alarm* alarm : {&bus_, &join_, &recovery_}) alarm->cancel();
  master_ = 0x0001'0002;
  interrupts_ = results_ = 0;
  timing_ = 0x0123'0000;
  error_interrupt_ = false;
  mode_ = Mode::kSleep;
  for (Mail& mailbox : mailboxes_) mailbox.fill(0);
  for (Fifo& fifo : fifos_) fifo = {};
  sender_ = Sender::kNobody;
  transmit_errors_ = receive_errors_ = last_error_ = 0;
  bus_off_ = false;
  filters_.reset();
  settle();
  contend();
}

std::uint32_t Can::master_status() const {
  constexpr std::uint32_t kRecessive = 0xC00;  // Level of RX, and its last sample.
  const bool initialising = mode_ == Mode::kInitialisation || mode_ == Mode::kJoining;
  return kRecessive | (initialising ? 1U : 0U) | (mode_ == Mode::kSleep ? 2U : 0U) |
         (error_interrupt_ ? 4U : 0U);
}

std::uint32_t Can::transmit_status() const {
  std::uint32_t status = results_;
  for (unsigned i = 0; i < kMailboxes; ++i) status |= (pending(i) ? 0U : 1U) << (26 + i);
  for (unsigned i = kMailboxes; i-- > 0;) {
    if (!pending(i)) status = (status & ~(3U << 24U)) | i << 24U;
  }
  return status;
}

std::uint32_t Can::error_flags() const {
  return (transmit_errors_ >= 96 || receive_errors_ >= 96 ? kWarning : 0) |
         (transmit_errors_ > 127 || receive_errors_ > 127 ? kPassive : 0) |
         (bus_off_ ? kBusOff : 0);
}

std::uint32_t Can::error_status() const {
  const std::uint32_t sent = transmit_errors_ > 255 ? 255 : transmit_errors_;
  return error_flags() | last_error_ << 4U | sent << 16U | receive_errors_ << 24U;
}

std::uint32_t Can::read(std::uint32_t offset) {
  if (offset >= kFilters) return filters_.read(offset);
  if (offset >= kMailboxWords && offset < kMailWords) {
    return mailboxes_[(offset - kMailboxWords) / 16][offset / 4 % 4];
  }
  if (offset >= kMailWords && offset < kMailWordsEnd) {
    const Fifo& fifo = fifos_[(offset - kMailWords) / 16];
    return fifo.mails.empty() ? 0 : fifo.mails.front()[offset / 4 % 4];
  }
  switch (offset) {
    case kMaster:
      return master_;
    case kMasterStatus:
      return master_status();
    case kTransmitStatus:
      return transmit_status();
    case kFifo0:
      return fifos_[0].flags | static_cast<std::uint32_t>(fifos_[0].mails.size());
    case kFifo1:
      return fifos_[1].flags | static_cast<std::uint32_t>(fifos_[1].mails.size());
    case kInterrupts:
      return interrupts_;
    case kErrors:
      return error_status();
    case kTiming:
      return timing_;
    default:
      return 0;
  }
}

void Can::write(std::uint32_t offset, std::uint32_t value) {
  if (offset >= kFilters) {
    filters_.write(offset, value);
  } else if (offset >= kMailboxWords && offset < kMailWords) {
    write_mailbox((offset - kMailboxWords) / 16, offset / 4 % 4, value);
  } else if (offset == kMaster) {
    write_master(value);
  } else if (offset == kMasterStatus) {
    if ((value & 4U) != 0) error_interrupt_ = false;
  } else if (offset == kTransmitStatus) {
    write_transmit_status(value);
  } else if (offset == kFifo0 || offset == kFifo1) {
    write_fifo(fifos_[(offset - kFifo0) / 4], value);
  } else if (offset == kInterrupts) {
    interrupts_ = value & 0x0003'8F7FU;
  } else if (offset == kErrors) {
    last_error_ = field(value, 4, 3);
  } else if (offset == kTiming) {
    if (mode_ != Mode::kInitialisation) return trace().misuse("CAN1", "BTR when not initialising");
    timing_ = value & 0xC37F'03FFU;
  }
  settle();
}

void Can::write_master(std::uint32_t value) {
  if ((value & kMasterReset) != 0) return reset();
  not_modelled(kMaster, value & 0xA0U);
  master_ = value & 0x0001'00DFU;
  change_mode();
}

void Can::write_transmit_status(std::uint32_t value) {
  for (unsigned i = 0; i < kMailboxes; ++i) {
    const std::uint32_t asked = value >> 8 * i;
    if ((asked & kDone) != 0) results_ &= ~(0xFU << 8 * i);
    const bool leaving = sender_ == Sender::kMailbox && sending_ == i;
    if ((asked & kAbort) != 0 && pending(i) && !leaving) answer_request(i, 0);
  }
}

void Can::write_fifo(Fifo& fifo, std::uint32_t value) {
  fifo.flags &= ~(value & (kFull | kOverrun));
  if ((value & kRelease) == 0 || fifo.mails.empty()) return;
  fifo.mails.pop_front();
  fifo.flags &= ~kFull;
}

void Can::write_mailbox(unsigned index, std::uint32_t word, std::uint32_t value) {
  if (pending(index)) return trace().misuse("CAN1", "mailbox {} is not empty", index);
  mailboxes_[index][word] = value;
  if (word != 0 || (value & 1U) == 0) return;
  results_ &= ~(0xFU << 8 * index);
  requested_[index] = ++requests_;
  contend();
}

void Can::answer_request(unsigned mailbox, std::uint32_t result) {
  mailboxes_[mailbox][0] &= ~1U;
  results_ |= (kDone | result) << 8 * mailbox;
}

void Can::settle() {
  constexpr std::uint32_t kAllDone = 0x0001'0101;
  transmit_line_.set((interrupts_ & kEmptyInterrupt) != 0 && (results_ & kAllDone) != 0);
  const auto wants = [this](unsigned index) {
    const Fifo& fifo = fifos_[index];
    const std::uint32_t enabled = interrupts_ >> (1 + 3 * index);
    return ((enabled & 1U) != 0 && !fifo.mails.empty()) ||
           ((enabled & 2U) != 0 && (fifo.flags & kFull) != 0) ||
           ((enabled & 4U) != 0 && (fifo.flags & kOverrun) != 0);
  };
  fifo0_line_.set(wants(0));
  fifo1_line_.set(wants(1));
  status_line_.set(error_interrupt_ && (interrupts_ & kErrorsOn) != 0);
}

}  // namespace machine
