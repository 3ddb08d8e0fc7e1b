#pragma once

#include <string>
#include <string_view>

namespace sim {

/// The value of `Sec-WebSocket-Accept` for a client's key (RFC 6455, 4.2.2): Base64 of the SHA-1
/// (FIPS 180-4) of the key and a fixed text.
[[nodiscard]] std::string web_accept_key(std::string_view client_key);

}  // namespace sim
