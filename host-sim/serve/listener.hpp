#pragma once

#include <optional>
#include <string_view>

#include "hal/host/descriptor.hpp"
#include "host-sim/serve/internet_address.hpp"

namespace sim {

/// Listens for TCP connections. Port 0 becomes the free one that was taken. Throws
/// std::system_error naming `way` and the address.
[[nodiscard]] hal::host::Descriptor listen_at(InternetAddress& address, std::string_view way);

/// The next connection, as it suits a conversation: it does not block, small answers leave at
/// once, and an end that is not there any more is noticed within some ten seconds. Nothing when
/// nobody waits.
[[nodiscard]] std::optional<hal::host::Descriptor> accept_at(const hal::host::Descriptor& listener);

/// After a call that failed: whether it only has to be made again, later.
[[nodiscard]] bool is_only_slow();

}  // namespace sim
