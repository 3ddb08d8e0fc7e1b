#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/interface/byte_stream.hpp"
#include "hal/interface/session_stream.hpp"

namespace cnc {

/// Chooses the active one of two links: the first link while a sender has it open, otherwise the
/// second link, which is always available. Main loop.
///
/// Answers go to the active link. Bytes that arrive on the second link while the first is active
/// are dropped. If the last dropped byte is within a line, the rest of that line is dropped, too.
/// So no line is composed of bytes from two senders, and no line lacks its beginning.
class LinkChoice final : public hal::ByteStream {
 public:
  enum class Change : std::uint8_t {
    kNone,
    kCame,  ///< A sender opened the first link.
    kWent,  ///< The sender is gone, and no other sender has come.
  };

  /// @pre both links outlive this object
  LinkChoice(hal::SessionStream& first, hal::ByteStream& second) : first_{first}, second_{second} {}

  /// Updates which link is active; the choice stays until the next call. Called before each cycle.
  [[nodiscard]] Change attend();

  [[nodiscard]] bool first_has_word() const { return session_ != 0; }

  /// Read from and write to the active link. No byte is exchanged with a sender that opened the
  /// first link after the last attend().
  [[nodiscard]] std::size_t read(std::span<std::byte> into) override;
  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override;
  [[nodiscard]] bool may_wait() const override {
    return session_ != 0 ? first_.may_wait() : second_.may_wait();
  }

 private:
  void drop_second();
  [[nodiscard]] bool belongs_to_whole_line(std::byte byte);

  hal::SessionStream& first_;
  hal::ByteStream& second_;
  /// Session of the first link; 0 means that the second link is active.
  std::uint32_t session_ = 0;
  bool within_line_ = false;  ///< The last byte of the second link is within a line.
  bool skipping_ = false;  ///< The beginning of this line was dropped, so its rest is dropped, too.
};

}  // namespace cnc
