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

/// The bytes of the messages that arrive. A message counts only when it is whole: of one in
/// which a frame is missing nothing is ever read. Main loop; bounded work for each call.
///
/// Room is promised before it is used: a sender is allowed as many frames as fit, and waits for
/// the next block. Single frames and first ones need no leave, so some room is kept for them.
class IsoTpReceiver {
 public:
  static constexpr std::uint32_t kBytes = 512;
  /// For what comes without leave, while others wait for theirs.
  static constexpr std::uint32_t kReserve = 64;
  static constexpr std::uint32_t kLongest = kBytes - kReserve;  ///< Longer messages are refused.

  IsoTpReceiver() = default;
  IsoTpReceiver(const IsoTpReceiver&) = delete;
  IsoTpReceiver& operator=(const IsoTpReceiver&) = delete;
  ~IsoTpReceiver() = default;

  struct Counts {
    std::uint32_t broken = 0;  ///< Messages of which frames were missing, or that nobody ended.
    std::uint32_t lost = 0;    ///< Messages, or their beginnings, for which there was no room.
  };

  /// A frame of a message. Those of no known kind, or too short, are passed over, as the
  /// standard says.
  void take(std::span<const std::byte> payload, hal::TickCount now);

  /// The flow control that is due, if one is. @param now microseconds
  [[nodiscard]] std::optional<iso_tp::FlowControl> flow_due(hal::TickCount now);

  /// Copies bytes of whole messages; returns how many.
  [[nodiscard]] std::size_t read(std::span<std::byte> into);
  /// Forgets all there is.
  void clear();

  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  /// Shorter than N_Bs by far, which the sender waits for.
  static constexpr std::uint32_t kWaitUs = 100'000;
  /// A block that is worth a frame of flow control, unless the message ends with it.
  static constexpr std::uint32_t kLeastBlock = 8;

  enum class Flow : std::uint8_t { kNone, kAsked, kWaiting, kOverflow };

  void take_single(std::span<const std::byte> payload);
  void take_first(std::span<const std::byte> payload);
  void take_consecutive(std::span<const std::byte> payload);
  void abandon();
  [[nodiscard]] std::uint32_t frames_left() const;
  [[nodiscard]] std::uint32_t frames_that_fit() const;

  std::array<std::byte, kBytes> storage_{};
  TextQueue text_{storage_};
  std::uint32_t left_ = 0;   ///< Bytes still to come of the message; 0: none is under way.
  std::uint32_t block_ = 0;  ///< Frames that the sender was allowed and has not sent.
  std::uint8_t number_ = 0;  ///< Of the next frame.
  Flow flow_ = Flow::kNone;
  hal::TickCount last_{};  ///< The last frame of the message, or the last flow control.
  Counts counts_{};
};

}  // namespace cnc
