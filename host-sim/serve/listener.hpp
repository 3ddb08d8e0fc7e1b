#pragma once

#include <optional>
#include <string_view>

#include "hal/host/descriptor.hpp"
#include "host-sim/serve/internet_address.hpp"

namespace sim {

/// Listens for TCP connections. If the port is 0, a free one is taken and written to `address`.
/// Throws std::system_error naming `way` and the address.
/// @param way kind of the transport, for messages
[[nodiscard]] hal::host::Descriptor listen_at(InternetAddress& address, std::string_view way);

/// Returns the next connection; empty if none waits. Its calls do not block, small answers are sent
/// immediately, and a lost peer is noticed within about ten seconds.
[[nodiscard]] std::optional<hal::host::Descriptor> accept_at(const hal::host::Descriptor& listener);

/// Returns whether the last failed call, by `errno`, needs only to be repeated later.
[[nodiscard]] bool is_only_slow();

}  // namespace sim
