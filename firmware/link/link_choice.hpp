#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/interface/byte_stream.hpp"
#include "hal/interface/session_stream.hpp"

namespace cnc {

/// Chooses the active one of two links: the first while a sender has it open, otherwise the second,
/// which is always there. Main loop.
///
/// Answers go to the active link. Bytes that arrive over the second link while the first is active
/// are dropped. If they ended within a line, the rest of that line is dropped, too. So no line is
/// composed of bytes from two senders, and none is the end of a longer line.
class LinkChoice final : public hal::ByteStream {
 public:
  enum class Change : std::uint8_t {
    kNone,
    kCame,  ///< A sender opened the first link.
    kWent,  ///< The sender is gone, and no other came.
  };

  /// @pre both links outlive this object
  LinkChoice(hal::SessionStream& first, hal::ByteStream& second) : first_{first}, second_{second} {}

  /// Checks which link is active; the choice holds until the next call. To be called before each
  /// cycle.
  [[nodiscard]] Change attend();

  [[nodiscard]] bool first_has_word() const { return session_ != 0; }

  /// Reads from and writes to the active link. Nothing passes from or to a sender that came after
  /// the last attend().
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
  std::uint32_t session_ = 0;  ///< Session of the first link; 0: the second is active.
  bool within_line_ = false;   ///< The second link is within a line.
  bool skipping_ = false;      ///< The beginning of that line was dropped.
};

}  // namespace cnc
