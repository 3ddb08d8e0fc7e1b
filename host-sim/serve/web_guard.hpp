#pragma once

#include <string_view>

#include "host-sim/serve/internet_address.hpp"

namespace sim {

/// Whether a request that names this `Host`, in any case, was meant for us.
///
/// A page from elsewhere can make a browser ask us under its own name (DNS
/// rebinding), but not under `localhost` or a number. So those are served, and
/// numbers other than loopback only where we listen beyond this machine. A
/// missing header is an empty one.
[[nodiscard]] bool is_our_host(std::string_view host, const InternetAddress& listening);

/// Whether a request may come from a page of this `Origin`: the very one that this `Host` serves,
/// or none at all, as with senders that are no browsers. An empty origin is none. Any other page
/// is foreign, at whatever address it lies.
[[nodiscard]] bool is_same_origin(std::string_view origin, std::string_view host);

}  // namespace sim
