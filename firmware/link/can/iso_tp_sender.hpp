#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/link/can/iso_tp.hpp"
#include "firmware/link/can/text_queue.hpp"
#include "hal/interface/tick_count.hpp"

namespace cnc {

/// Text on its way to the other side, in messages of what waits when one begins. Main
/// loop; bounded work for each call.
///
/// A message leaves its place only with its last frame, so that it can be begun again.
class IsoTpSender {
 public:
  struct Counts {
    std::uint32_t again = 0;  ///< Messages begun anew because nobody answered.
    std::uint32_t given_up = 0;
  };

  /// @param storage outlives this; a power of two
  /// @param longest message, unless the other side wants shorter ones; twice as much storage lets
  /// the next one gather while one is under way
  IsoTpSender(std::span<std::byte> storage, std::uint32_t longest)
      : text_{storage}, most_{longest}, longest_{longest} {}

  /// Queues what there is room for; returns how many bytes.
  [[nodiscard]] std::size_t write(std::span<const std::byte> from);
  /// Nothing waits and nothing is under way.
  [[nodiscard]] bool empty() const { return text_.settled() == 0; }

  /// A frame from the other side; only flow control concerns this one.
  void take(std::span<const std::byte> payload, hal::TickCount now);

  /// The next frame, if one may go now; it must go then. @param now microseconds
  [[nodiscard]] std::optional<iso_tp::Payload> next(hal::TickCount now);

  /// Forgets all there is.
  void clear();

  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  /// Of one message, until the other side counts as gone.
  static constexpr std::uint8_t kTries = 3;
  /// Flow controls in a row that say wait: 25 s of a receiver that asks every 100 ms.
  static constexpr std::uint8_t kMostWaits = 250;

  enum class Step : std::uint8_t { kIdle, kAwaitsFlow, kSends };

  [[nodiscard]] iso_tp::Payload begin(hal::TickCount now);
  [[nodiscard]] iso_tp::Payload consecutive(hal::TickCount now);
  void append(iso_tp::Payload& payload, std::uint32_t count);
  void end_message();
  void give_up();

  TextQueue text_;
  Step step_ = Step::kIdle;
  std::uint32_t length_ = 0;  ///< Of the message under way.
  std::uint32_t sent_ = 0;    ///< Bytes of it.
  std::uint32_t block_ = 0;   ///< Frames that may go before the next flow control.
  std::uint32_t most_;
  std::uint32_t longest_;  ///< That the other side has room for.
  std::uint32_t separation_us_ = 0;
  std::uint8_t number_ = 0;
  std::uint8_t tries_ = 0;
  std::uint8_t waits_ = 0;
  bool endless_ = false;    ///< No further flow control.
  hal::TickCount since_{};  ///< The last frame either way.
  Counts counts_{};
};

}  // namespace cnc
