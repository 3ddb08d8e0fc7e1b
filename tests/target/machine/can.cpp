// Events on the wire: modes, arbitration, errors and their counters, bus-off.

#include "tests/target/machine/can.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

#include "tests/target/machine/can_registers.hpp"

namespace machine {

// NOLINT(google-build-using-namespace): half of this file uses these names.
using namespace can_registers;

namespace {

constexpr unsigned kTransmitInterrupt = 19, kFifo0Interrupt = 20, kFifo1Interrupt = 21;
constexpr unsigned kStatusInterrupt = 22;
// Numbers of bits by ISO 11898-1: silence before a node takes part, and before it leaves bus-off;
// an error flag with its delimiter and the intermission; the additional wait of a passive sender.
constexpr unsigned kJoinBits = 11, kRecoveryBits = 128 * 11, kErrorBits = 6 + 8 + 3;
constexpr unsigned kPassiveWait = 8;

}  // namespace

Can::Can(const Services& services, const Options& options, const std::vector<TimedFrame>& others)
    : Peripheral{services, {"CAN1", 0x4000'6400, {Bus::kApb1, 25}}},
      options_{options},
      others_{others},
      random_{options.seed},
      transmit_line_{services.interrupts, kTransmitInterrupt},
      fifo0_line_{services.interrupts, kFifo0Interrupt},
      fifo1_line_{services.interrupts, kFifo1Interrupt},
      status_line_{services.interrupts, kStatusInterrupt},
      bus_{[this] { over(); }},
      join_{[this] { joined(); }},
      recovery_{[this] { recover(); }} {
  if (options.can_output.empty()) return;
  output_ = std::fopen(options.can_output.c_str(), "w");
  if (output_ != nullptr) return;
  fmt::print(stderr, "machine: cannot write {}\n", options.can_output);
  std::exit(1);
}

Can::~Can() {
  if (output_ != nullptr) std::fclose(output_);
}

void Can::flush() const {
  if (output_ != nullptr) std::fflush(output_);
}

std::int64_t Can::bits_ns(std::uint64_t bits) const {
  const std::uint64_t quanta = 3 + field(timing_, 16, 4) + field(timing_, 20, 3);
  const std::uint64_t clocks_per_bit = quanta * (field(timing_, 0, 10) + 1);
  return static_cast<std::int64_t>(bits * clocks_per_bit * kSecond_ns /
                                   clocks().bus_hz(Bus::kApb1));
}

void Can::change_mode() {
  if (sender_ == Sender::kMailbox) return;  // The mode changes at the end of the frame.
  const bool initialise = (master_ & kInitialise) != 0, sleep = (master_ & kSleepRequest) != 0;
  if (initialise != sleep) {
    mode_ = initialise ? Mode::kInitialisation : Mode::kSleep;
    join_.cancel();
  } else if (!initialise && (mode_ == Mode::kInitialisation || mode_ == Mode::kSleep)) {
    mode_ = Mode::kJoining;
    join_.set(now_ns() + bits_ns(kJoinBits));
    if (bus_off_ && !recovery_.is_set()) recovery_.set(now_ns() + bits_ns(kRecoveryBits));
  }
}

void Can::joined() {
  mode_ = Mode::kNormal;
  contend();
}

CanFrame Can::frame_in(unsigned mailbox) const {
  const Mail& mail = mailboxes_[mailbox];
  CanFrame frame;
  frame.extended = (mail[0] & 4U) != 0;
  frame.remote = (mail[0] & 2U) != 0;
  frame.id = frame.extended ? mail[0] >> 3U : mail[0] >> 21U;
  frame.length = static_cast<std::uint8_t>(std::min(field(mail[1], 0, 4), 8U));
  for (unsigned i = 0; i < 8; ++i) {
    frame.data[i] = static_cast<std::uint8_t>(mail[2 + i / 4] >> i % 4 * 8);
  }
  return frame;
}

int Can::next_mailbox() const {
  int best = -1;
  std::uint64_t best_key = 0;
  for (unsigned i = 0; i < kMailboxes; ++i) {
    if (!pending(i)) continue;
    const bool by_request = (master_ & kByTime) != 0;
    const std::uint64_t key = by_request ? requested_[i] : arbitration(frame_in(i));
    if (best >= 0 && key >= best_key) continue;
    best = static_cast<int>(i);
    best_key = key;
  }
  return best;
}

void Can::contend() {
  if (sender_ != Sender::kNobody) return;
  const bool silent = (timing_ & kSilent) != 0 && (timing_ & kLoop) == 0;
  const int mailbox = on_bus() && !silent ? next_mailbox() : -1;
  const bool other_waits = next_other_ < others_.size();
  const bool other = other_waits && others_[next_other_].at_ns <= now_ns();
  if (mailbox >= 0) {
    const CanFrame own = frame_in(static_cast<unsigned>(mailbox));
    if (!other || arbitration(own) <= arbitration(others_[next_other_].frame)) {
      sending_ = static_cast<unsigned>(mailbox);
      return begin(Sender::kMailbox, own);
    }
    if ((master_ & kOnce) != 0) answer_request(static_cast<unsigned>(mailbox), kLost);
  }
  if (other) return begin(Sender::kOther, others_[next_other_].frame);
  if (other_waits) bus_.set(others_[next_other_].at_ns);
}

void Can::begin(Sender sender, const CanFrame& frame) {
  sender_ = sender;
  const bool own = sender == Sender::kMailbox;
  unsigned bits = bits_on_wire(frame);
  failure_ = 0;
  if (random_.below(100) < options_.can_corrupt_percent) {
    failure_ = own ? kRecessiveError : kStuffError;
    // The error occurs at a random bit before the end of the frame.
    bits = 1 + random_.below(bits - 10) + kErrorBits;
  } else if (own && options_.can_alone && (timing_ & kLoop) == 0) {
    failure_ = kAcknowledgeError;
    bits = bits - 11 + kErrorBits;
  }
  if (own && transmit_errors_ > 127) bits += kPassiveWait;
  bus_.set(now_ns() + bits_ns(bits));
}

void Can::over() {
  const Sender sender = sender_;
  sender_ = Sender::kNobody;
  if (sender == Sender::kMailbox) finish_own();
  if (sender == Sender::kOther) finish_other();
  if (sender != Sender::kNobody) change_mode();
  contend();
  settle();
}

void Can::finish_own() {
  const CanFrame frame = frame_in(sending_);
  if (failure_ != 0) {
    count_error(failure_, true);
    if ((master_ & kOnce) != 0) answer_request(sending_, kFailed);
    return;
  }
  last_error_ = 0;
  if (transmit_errors_ > 0) --transmit_errors_;
  trace().event("can", "tx {}", text_of(frame));
  const bool hidden = (timing_ & kLoop) != 0 && (timing_ & kSilent) != 0;
  if (output_ != nullptr && !hidden) fmt::print(output_, "{} {}\n", now_ns(), text_of(frame));
  answer_request(sending_, kGood);
  if ((timing_ & kLoop) != 0) receive(frame);
}

void Can::finish_other() {
  const bool listening = on_bus() && (timing_ & kLoop) == 0;
  if (failure_ != 0) {
    if (listening) count_error(failure_, false);
    return;  // The other node tries again.
  }
  const CanFrame& frame = others_[next_other_++].frame;
  trace().event("can", "rx {}", text_of(frame));
  if (!listening) return;
  last_error_ = 0;
  if (receive_errors_ > 127) {
    receive_errors_ = 120;
  } else if (receive_errors_ > 0) {
    --receive_errors_;
  }
  receive(frame);
}

void Can::receive(const CanFrame& frame) {
  const auto passed = filters_.pass(frame);
  if (!passed) return;
  Mail mail{};
  mail[0] = (frame.extended ? frame.id << 3U | 4U : frame.id << 21U) | (frame.remote ? 2U : 0U);
  mail[1] = frame.length | passed->index << 8U;
  for (unsigned i = 0; i < 8; ++i) {
    mail[2 + i / 4] |= static_cast<std::uint32_t>(frame.data[i]) << i % 4 * 8;
  }
  Fifo& fifo = fifos_[passed->fifo];
  if (fifo.mails.size() == kDepth) {
    fifo.flags |= kOverrun;
    if ((master_ & kLockFifos) != 0) return;
    fifo.mails.pop_back();
  }
  fifo.mails.push_back(mail);
  if (fifo.mails.size() == kDepth) fifo.flags |= kFull;
}

void Can::count_error(std::uint32_t code, bool sending) {
  const std::uint32_t before = error_flags();
  last_error_ = code;
  // A passive node whose frames no other node acknowledges stops counting. Otherwise a node that
  // is alone would go bus-off.
  const bool counts = code != kAcknowledgeError || transmit_errors_ <= 127;
  if (sending && counts) transmit_errors_ += 8;
  if (!sending && receive_errors_ < 255) ++receive_errors_;
  trace().event("can", "error {} tec {} rec {}", code, transmit_errors_, receive_errors_);
  if (transmit_errors_ > 255) go_bus_off();
  raise_errors(before);
}

void Can::raise_errors(std::uint32_t before) {
  const std::uint32_t risen = error_flags() & ~before;
  // The enable bits of EWGF, EPVF and BOFF are 8 bits above their flags.
  if ((risen & interrupts_ >> 8U) != 0 || (interrupts_ & kCodeInterrupt) != 0) {
    error_interrupt_ = true;
  }
}

void Can::go_bus_off() {
  bus_off_ = true;
  trace().event("can", "bus-off");
  if ((master_ & kRecoverAlone) != 0) recovery_.set(now_ns() + bits_ns(kRecoveryBits));
}

void Can::recover() {
  bus_off_ = false;
  transmit_errors_ = receive_errors_ = 0;
  trace().event("can", "recovered");
  contend();
}

}  // namespace machine
