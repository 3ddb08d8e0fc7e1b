#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/link/can/iso_tp.hpp"
#include "firmware/link/can/text_queue.hpp"
#include "hal/interface/tick_count.hpp"

namespace cnc {

/// Sends text in messages. A message takes the bytes that wait when it begins. Main loop; the work
/// of each call is bounded.
///
/// The bytes of a message stay in the queue until its last frame is sent, so that the message can
/// be restarted.
class IsoTpSender {
 public:
  struct Counts {
    std::uint32_t again = 0;  ///< Messages restarted for lack of an answer.
    std::uint32_t given_up = 0;
  };

  /// @param storage outlives this object; its size is a power of two
  /// @param longest length of the longest message, unless the other side requires shorter ones.
  ///   Storage of twice that length lets the next message gather while one is being sent.
  IsoTpSender(std::span<std::byte> storage, std::uint32_t longest)
      : text_{storage}, max_{longest}, longest_{longest} {}

  /// Queues as many bytes as fit; returns how many.
  [[nodiscard]] std::size_t write(std::span<const std::byte> from);
  /// Returns whether no byte waits and no message is being sent.
  [[nodiscard]] bool empty() const { return text_.settled() == 0; }

  /// Takes a frame from the other side; only flow control has an effect.
  void take(std::span<const std::byte> payload, hal::TickCount now);

  /// Returns the next frame if one may be sent now; the caller must then send it.
  /// @param now microseconds
  [[nodiscard]] std::optional<iso_tp::Payload> next(hal::TickCount now);

  /// Drops all bytes.
  void clear();

  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  /// Number of attempts to send one message before the other side counts as gone.
  static constexpr std::uint8_t kTries = 3;
  /// Most flow controls in a row that say wait: 25 s for a receiver that sends one every 100 ms.
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
  std::uint32_t sent_ = 0;    ///< Bytes of the message sent so far.
  std::uint32_t block_ = 0;   ///< Frames allowed before the next flow control.
  std::uint32_t max_;
  std::uint32_t longest_;  ///< Longest message that the other side can take.
  std::uint32_t separation_us_ = 0;
  std::uint8_t number_ = 0;
  std::uint8_t tries_ = 0;
  std::uint8_t waits_ = 0;
  bool endless_ = false;    ///< No further flow control is needed.
  hal::TickCount since_{};  ///< Time of the last frame in either direction.
  Counts counts_{};
};

}  // namespace cnc
