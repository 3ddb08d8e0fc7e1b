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

/// Reads a sender's stream ahead of the controller, so that realtime bytes act and a closed
/// connection is noticed however many lines wait.
///
/// A second `cnc::Receiver` sorts the bytes by the controller's own rules. Realtime bytes overtake
/// the lines and act immediately. Bytes of lines wait here until the controller has capacity for
/// them. A reset forgets the lines before it, as it does in the controller. In a tool change, 0xA3
/// and `~` keep their position among the lines, because they determine which lines belong to the
/// tool change.
class LookAhead {
 public:
  /// Greatest number of bytes of lines that wait. A sender that is further ahead must be
  /// disconnected, because its realtime bytes could not be read any more.
  static constexpr std::size_t kMax = std::size_t{64} << 20;

  LookAhead();

  /// Sorts the bytes that a sender has sent, in order, into realtime bytes and lines.
  void hear(std::span<const std::byte> bytes, Session& session);
  /// Hands lines to the controller as far as its link has capacity.
  void hand_over(Session& session);

  /// Removes and returns all waiting lines, and the beginning of an unfinished line, instead of
  /// handing them to the controller. Realtime bytes among them act.
  [[nodiscard]] std::string take_lines(Session& session);

  [[nodiscard]] std::size_t size() const { return lines_.size(); }
  [[nodiscard]] bool overrun() const { return size() > kMax; }
  /// Drops all bytes, when a sender disconnects or another one begins.
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
