#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/link/can/iso_tp.hpp"
#include "firmware/link/can/text_queue.hpp"
#include "hal/interface/tick_count.hpp"

namespace cnc {

/// Collects the bytes of received messages. A message counts only when it is whole: if a frame of
/// it is missing, none of its bytes is ever read. Main loop; the work of each call is bounded.
///
/// Free space is reserved before it is used: a sender is allowed as many frames as fit, and then
/// waits for the next flow control. Single and first frames need no permission, so some space is
/// reserved for them.
class IsoTpReceiver {
 public:
  static constexpr std::uint32_t kBytes = 512;
  /// Space for frames without permission, while other senders wait for theirs.
  static constexpr std::uint32_t kReserve = 64;
  static constexpr std::uint32_t kLongest = kBytes - kReserve;  ///< Longer messages are refused.

  IsoTpReceiver() = default;
  IsoTpReceiver(const IsoTpReceiver&) = delete;
  IsoTpReceiver& operator=(const IsoTpReceiver&) = delete;
  ~IsoTpReceiver() = default;

  struct Counts {
    std::uint32_t broken = 0;  ///< Messages with missing frames, or without an end.
    std::uint32_t lost = 0;    ///< Messages, or beginnings of messages, without free space.
  };

  /// Takes a frame of a message. Frames of an unknown kind and frames that are too short are
  /// ignored, as the standard requires.
  void take(std::span<const std::byte> payload, hal::TickCount now);

  /// Returns the flow control that is due, if any.
  /// @param now microseconds
  [[nodiscard]] std::optional<iso_tp::FlowControl> flow_due(hal::TickCount now);

  /// Copies bytes of complete messages; returns how many.
  [[nodiscard]] std::size_t read(std::span<std::byte> into);
  /// Drops all messages.
  void clear();

  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  /// Interval between flow controls that say wait: much shorter than N_Bs, the timeout of the
  /// sender.
  static constexpr std::uint32_t kWaitUs = 100'000;
  /// Smallest block worth a frame of flow control, unless the block ends the message.
  static constexpr std::uint32_t kMinBlock = 8;

  enum class Flow : std::uint8_t { kNone, kAsked, kWaiting, kOverflow };

  void take_single(std::span<const std::byte> payload);
  void take_first(std::span<const std::byte> payload);
  void take_consecutive(std::span<const std::byte> payload);
  void abandon();
  [[nodiscard]] std::uint32_t frames_left() const;
  [[nodiscard]] std::uint32_t frames_that_fit() const;

  std::array<std::byte, kBytes> storage_{};
  TextQueue text_{storage_};
  std::uint32_t left_ = 0;   ///< Bytes of the message still to come; 0: no message is incomplete.
  std::uint32_t block_ = 0;  ///< Allowed frames that the sender has not sent yet.
  std::uint8_t number_ = 0;  ///< Sequence number of the next frame.
  Flow flow_ = Flow::kNone;
  hal::TickCount last_{};  ///< Time of the message's last frame, or of the last flow control.
  Counts counts_{};
};

}  // namespace cnc
