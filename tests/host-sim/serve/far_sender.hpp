#pragma once

#include <string>
#include <string_view>

#include "hal/host/descriptor.hpp"
#include "host-sim/serve/internet_address.hpp"

namespace sim {

/// A sender's end of a link that waits for nothing but the link itself: it writes as far ahead
/// as the link lets it.
class FarSender {
 public:
  enum class Way { kTcp, kPty, kWebSocket };
  /// How it goes away.
  enum class End { kClose, kReset };

  /// Throws std::system_error.
  static FarSender over_tcp(const InternetAddress& address);
  static FarSender over_pty(const std::string& device);
  static FarSender over_web_socket(const InternetAddress& address);

  /// Returns when the link has taken all of it. Reads meanwhile.
  void send(std::string_view bytes);
  /// What has come, with what came before; waits for `words`. False after 20 s.
  [[nodiscard]] bool hears(std::string_view words);
  void forget() { heard_.clear(); }
  void leave(End how);

 private:
  FarSender(hal::host::Descriptor link, bool frames) : link_{std::move(link)}, frames_{frames} {}

  void put(std::string_view bytes);
  void read();

  hal::host::Descriptor link_;
  bool frames_ = false;  ///< As WebSocket's; what comes is searched with its frame heads.
  std::string heard_;
};

}  // namespace sim
