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

/// Collects the bytes of received messages. A message counts only when it is complete: if one of
/// its frames is missing, read() returns none of its bytes. Main loop; the work of each call is
/// bounded.
///
/// The receiver allows a sender only as many frames as fit in the free space; the sender then waits
/// for the next flow control. Single frames and first frames need no permission, so kReserve bytes
/// are kept free for them.
class IsoTpReceiver {
 public:
  static constexpr std::uint32_t kBytes = 512;
  /// Free space that only frames without permission may use (single frames and first frames), in
  /// bytes.
  static constexpr std::uint32_t kReserve = 64;
  /// Length of the longest accepted message, bytes.
  static constexpr std::uint32_t kLongest = kBytes - kReserve;

  IsoTpReceiver() = default;
  IsoTpReceiver(const IsoTpReceiver&) = delete;
  IsoTpReceiver& operator=(const IsoTpReceiver&) = delete;
  ~IsoTpReceiver() = default;

  struct Counts {
    /// Number of messages that were dropped because a frame was missing.
    std::uint32_t broken = 0;
    /// Number of messages that were dropped because there was no free space for their first frame.
    std::uint32_t lost = 0;
  };

  /// Processes a frame of a message. Frames of an unknown kind and frames that are too short are
  /// ignored, as the standard requires.
  void take(std::span<const std::byte> payload, hal::TickCount now);

  /// Returns the flow control that is due, if any.
  /// @param now microseconds
  [[nodiscard]] std::optional<iso_tp::FlowControl> flow_due(hal::TickCount now);

  /// Copies bytes of complete messages to `into`. Returns the number of bytes.
  [[nodiscard]] std::size_t read(std::span<std::byte> into);
  /// Drops all messages.
  void clear();

  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  /// Interval between flow controls with the status kWait, microseconds. It is much shorter than
  /// N_Bs, the timeout of the sender.
  static constexpr std::uint32_t kWaitUs = 100'000;
  /// Smallest number of frames for which a flow control is sent, unless fewer frames end the
  /// message.
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
  /// Number of bytes of the message that have not arrived; 0: no message is incomplete.
  std::uint32_t left_ = 0;
  std::uint32_t block_ = 0;  ///< Number of frames that are allowed and have not arrived.
  std::uint8_t number_ = 0;  ///< Sequence number of the next frame.
  Flow flow_ = Flow::kNone;
  hal::TickCount last_{};  ///< Time of the message's last frame, or of the last flow control.
  Counts counts_{};
};

}  // namespace cnc
