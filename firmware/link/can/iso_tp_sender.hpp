#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/link/can/iso_tp.hpp"
#include "firmware/link/can/text_queue.hpp"
#include "hal/interface/tick_count.hpp"

namespace cnc {

/// Sends text in messages. A new message takes all bytes that wait at that time, up to the longest
/// length. Main loop; the work of each call is bounded.
///
/// The bytes of a message stay in the queue until its last frame is sent, so that the message can
/// be restarted.
class IsoTpSender {
 public:
  struct Counts {
    std::uint32_t again = 0;  ///< Number of restarts of a message because no flow control came.
    std::uint32_t given_up = 0;
  };

  /// @param storage memory of the queue; outlives this object; its size is a power of two
  /// @param longest length of the longest message, bytes, unless the receiver requires shorter
  ///     ones. If `storage` has twice this length, the bytes of the next message can be queued
  ///     while a message is sent.
  IsoTpSender(std::span<std::byte> storage, std::uint32_t longest)
      : text_{storage}, max_{longest}, longest_{longest} {}

  /// Queues as many bytes as fit. Returns the number of queued bytes.
  [[nodiscard]] std::size_t write(std::span<const std::byte> from);
  /// Returns whether no byte waits and no message is being sent.
  [[nodiscard]] bool empty() const { return text_.settled() == 0; }

  /// Processes a frame from the receiver; only flow control has an effect.
  void take(std::span<const std::byte> payload, hal::TickCount now);

  /// Returns the next frame if one may be sent now. The caller must then send it.
  /// @param now microseconds
  [[nodiscard]] std::optional<iso_tp::Payload> next(hal::TickCount now);

  /// Drops all bytes.
  void clear();

  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  /// Number of attempts to send one message before the receiver counts as gone.
  static constexpr std::uint8_t kTries = 3;
  /// Largest number of consecutive flow controls with the status kWait: 25 s for a receiver that
  /// sends one every 100 ms.
  static constexpr std::uint8_t kMaxWaits = 250;

  enum class Step : std::uint8_t { kIdle, kAwaitsFlow, kSends };

  [[nodiscard]] iso_tp::Payload begin(hal::TickCount now);
  [[nodiscard]] iso_tp::Payload consecutive(hal::TickCount now);
  void append(iso_tp::Payload& payload, std::uint32_t count);
  void end_message();
  void give_up();

  TextQueue text_;
  Step step_ = Step::kIdle;
  std::uint32_t length_ = 0;  ///< Length of the message being sent.
  std::uint32_t sent_ = 0;    ///< Number of bytes of the message that were sent so far.
  std::uint32_t block_ = 0;   ///< Number of frames that may be sent before the next flow control.
  std::uint32_t max_;
  std::uint32_t longest_;  ///< Length of the longest message that the receiver can store.
  std::uint32_t separation_us_ = 0;
  std::uint8_t number_ = 0;
  std::uint8_t tries_ = 0;
  std::uint8_t waits_ = 0;
  bool endless_ = false;    ///< The receiver has allowed all further frames of the message.
  hal::TickCount since_{};  ///< Time of the last frame in either direction.
  Counts counts_{};
};

}  // namespace cnc
