#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/stm32f405/usb/device.hpp"
#include "hal/stm32f405/usb/otg_core.hpp"

namespace hal::stm32f405::usb {

/// Endpoint 0. A transfer has a request, its data in one direction, and an empty status packet at
/// the end (USB 2.0, 8.5.3), here called the nod. A new request ends an unfinished transfer. All
/// functions run in the USB interrupt.
template <RegisterBus Bus>
class ControlPipe {
 public:
  [[nodiscard]] Device& device() { return device_; }
  [[nodiscard]] const Device& device() const { return device_; }

  void begin_anew() noexcept {
    device_.reset();
    stage_ = Stage::kIdle;
  }

  // Functions for events. Called in the order in which the core received the events.

  /// Stores the bytes of a request. If several requests arrive, the last one counts.
  void take_request(std::size_t bytes) noexcept {
    received_ = 0;
    std::size_t at = 0;
    Core::receive(bytes, [&](std::byte byte) {
      if (at < kSetUpBytes) request_[at++] = byte;
    });
  }
  /// Stores received data. The nod has no data.
  void take_data(std::size_t bytes) noexcept {
    Core::receive(bytes, [&](std::byte byte) {
      if (received_ < incoming_.size()) incoming_[received_] = byte;
      ++received_;
    });
  }

  /// Answers the complete request. Returns the answer; the caller must carry out its effect.
  Answer on_request() noexcept {
    Core::stop_sending(0);
    const SetUp asked = set_up_of(request_);
    const Answer answer = device_.answer(asked);
    switch (answer.kind) {
      case Answer::Kind::kStall:
        stall();
        break;
      case Answer::Kind::kDone:
        nod();
        break;
      case Answer::Kind::kReceive:
        stage_ = Stage::kReceive;
        Core::allow_receiving(0);
        break;
      case Answer::Kind::kSend:
        stage_ = Stage::kSend;
        to_send_ = answer.data;
        // If the host requested more bytes than there are, a packet that is not full marks the end
        // of the data.
        ends_short_ = answer.data.size() < asked.length;
        Core::allow_receiving(0);  // The host may send its nod before it has fetched all data.
        send_next();
        break;
    }
    return answer;
  }

  /// Handles the end of received data, or a received nod.
  void on_received() noexcept {
    if (stage_ == Stage::kReceive) {
      if (received_ != Device::kLineCodingBytes) return stall();
      device_.take_data(incoming_);
      nod();
    } else {
      Core::stop_sending(0);
      finish();
    }
    // If the acknowledgement of a packet was lost, the host sends the packet again and expects
    // another acknowledgement.
    Core::allow_receiving(0);
  }

  /// Continues the transfer after the host has fetched a packet.
  void on_sent() noexcept {
    if (stage_ == Stage::kNod) {
      finish();
    } else if (stage_ == Stage::kSend && (!to_send_.empty() || ends_short_)) {
      send_next();
    }
  }

 private:
  using Core = OtgCore<Bus>;
  enum class Stage : std::uint8_t { kIdle, kSend, kReceive, kNod };

  void send_next() noexcept {
    const std::size_t bytes = to_send_.size() < kPacketBytes ? to_send_.size() : kPacketBytes;
    if (bytes < kPacketBytes) ends_short_ = false;
    Core::send(0, to_send_.first(bytes));
    to_send_ = to_send_.subspan(bytes);
  }
  void nod() noexcept {
    stage_ = Stage::kNod;
    Core::allow_requests();
    Core::send(0, {});
  }
  void stall() noexcept {
    finish();
    Core::stall(0, true);
    Core::stall(0, false);
  }
  void finish() noexcept {
    stage_ = Stage::kIdle;
    Core::allow_requests();
  }

  Device device_{};
  Stage stage_ = Stage::kIdle;
  bool ends_short_ = false;
  std::array<std::byte, kSetUpBytes> request_{};
  std::array<std::byte, Device::kLineCodingBytes> incoming_{};
  std::size_t received_ = 0;
  std::span<const std::byte> to_send_{};
};

}  // namespace hal::stm32f405::usb
