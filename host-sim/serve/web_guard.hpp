#pragma once

#include <string_view>

#include "host-sim/serve/internet_address.hpp"

namespace sim {

/// Returns whether a request that names this `Host`, in upper or lower case, was meant for this
/// server.
///
/// A page from another server can make a browser send a request to this server under the name of
/// that server (DNS rebinding), but not under `localhost` or a numeric address. So `localhost` and
/// numeric addresses are accepted. Numeric addresses other than loopback and the listening address
/// are accepted only if the server listens beyond this machine. A missing header is passed as an
/// empty `host`.
[[nodiscard]] bool is_our_host(std::string_view host, const InternetAddress& listening);

/// Returns whether a request may come from a page of this `Origin`. The origin of the pages that
/// this `Host` serves is allowed. An empty origin is allowed, too, because programs other than
/// browsers send none. Every other origin is refused.
[[nodiscard]] bool is_same_origin(std::string_view origin, std::string_view host);

}  // namespace sim
