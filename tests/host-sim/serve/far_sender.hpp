#pragma once

#include <string>
#include <string_view>

#include "hal/host/descriptor.hpp"
#include "host-sim/serve/internet_address.hpp"

namespace sim {

/// A sender's end of a link. It does not wait for answers, and writes as far ahead as the link lets
/// it.
class FarSender {
 public:
  enum class Way { kTcp, kPty, kWebSocket };
  /// How the sender ends the connection.
  enum class End { kClose, kReset };

  /// Opens a connection; throws std::system_error.
  static FarSender over_tcp(const InternetAddress& address);
  static FarSender over_pty(const std::string& device);
  static FarSender over_web_socket(const InternetAddress& address);

  /// Returns when the link has accepted all bytes. Reads meanwhile.
  void send(std::string_view bytes);
  /// Reads until `words` have come, now or before. Returns false after 20 s.
  [[nodiscard]] bool hears(std::string_view words);
  void forget() { heard_.clear(); }
  void leave(End how);

 private:
  FarSender(hal::host::Descriptor link, bool frames) : link_{std::move(link)}, frames_{frames} {}

  void put(std::string_view bytes);
  void read();

  hal::host::Descriptor link_;
  bool frames_ = false;  ///< True for WebSocket; received bytes are searched with their frame
                         ///< heads.
  std::string heard_;
};

}  // namespace sim
