#pragma once

#include <string_view>

#include "host-sim/serve/internet_address.hpp"

namespace sim {

/// Returns whether a request that names this `Host`, in upper or lower case, was meant for this
/// server.
///
/// A page from another server can make a browser send a request here under that server's name (DNS
/// rebinding), but not under `localhost` or a number. So `localhost` and numbers are accepted.
/// Numbers other than loopback and the listening address are accepted only if the server listens
/// beyond this machine. A missing header is passed as an empty `host`.
[[nodiscard]] bool is_our_host(std::string_view host, const InternetAddress& listening);

/// Returns whether a request may come from a page of this `Origin`. The origin that this `Host`
/// serves is allowed, and an empty origin, which programs other than browsers send. Every other
/// origin is refused.
[[nodiscard]] bool is_same_origin(std::string_view origin, std::string_view host);

}  // namespace sim
