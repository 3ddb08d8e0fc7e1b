#pragma once

#include <optional>
#include <string_view>

#include "hal/host/descriptor.hpp"
#include "host-sim/serve/internet_address.hpp"

namespace sim {

/// Listens for TCP connections. If the port is 0, the system chooses a free one, which is written
/// to `address`. Throws std::system_error naming `way` and the address.
/// @param way kind of the transport, for messages
[[nodiscard]] hal::host::Descriptor listen_at(InternetAddress& address, std::string_view way);

/// Returns the next connection; nothing if no connection waits. Calls on the connection do not
/// block, small answers are sent immediately, and a lost peer is noticed within about ten seconds.
[[nodiscard]] std::optional<hal::host::Descriptor> accept_at(const hal::host::Descriptor& listener);

/// Returns whether `errno` says that the last call failed only for now, so that it can be repeated
/// later.
[[nodiscard]] bool is_only_slow();

}  // namespace sim
