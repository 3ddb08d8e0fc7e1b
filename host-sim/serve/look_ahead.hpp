#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "firmware/link/receiver.hpp"
#include "host-sim/serve/byte_blocks.hpp"
#include "host-sim/serve/session.hpp"

namespace sim {

/// Reads a sender's stream ahead of the controller. So realtime bytes act, and a closed connection
/// is noticed, no matter how many lines wait.
///
/// A `cnc::Receiver` in addition to the controller's own one sorts the bytes by the same rules.
/// Realtime bytes overtake the lines and act immediately. Bytes of lines wait here until the
/// controller has capacity for them. A reset drops the lines before it, here as in the controller.
/// In a tool change, 0xA3 and `~` keep their position among the lines, because they determine which
/// lines belong to the tool change.
class LookAhead {
 public:
  /// Greatest number of bytes of lines that may wait. A sender with more waiting bytes must be
  /// disconnected, because its further bytes, including realtime bytes, cannot be read.
  static constexpr std::size_t kMax = std::size_t{64} << 20;

  LookAhead();

  /// Sorts the bytes that a sender has sent, in order, into realtime bytes and lines.
  void hear(std::span<const std::byte> bytes, Session& session);
  /// Hands lines to the controller as far as its link has capacity.
  void hand_over(Session& session);

  /// Removes and returns all waiting lines, including the beginning of an unfinished line. The
  /// controller does not receive them. Realtime bytes among them act.
  [[nodiscard]] std::string take_lines(Session& session);

  [[nodiscard]] std::size_t size() const { return lines_.size(); }
  [[nodiscard]] bool overrun() const { return size() > kMax; }
  /// Drops all bytes. Call it when a sender disconnects or another sender begins.
  void forget();

 private:
  void act_on_realtime(Session& session);
  [[nodiscard]] bool keep_in_order(cnc::RealtimeByte command, Session& session);
  void keep_lines();

  std::unique_ptr<cnc::Receiver> receiver_;  ///< Sorts the bytes; never null.
  ByteBlocks lines_;
  /// Realtime bytes that were kept among the lines. The list is emptied when the controller has
  /// read all lines.
  std::vector<cnc::RealtimeByte> marks_;
};

}  // namespace sim
