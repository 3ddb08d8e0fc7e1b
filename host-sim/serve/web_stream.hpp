#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <memory>

#include "host-sim/serve/web_socket.hpp"

namespace sim {

/// Answers a request for a WebSocket. Returns null if the handshake is malformed; the client has
/// been answered in that case.
[[nodiscard]] std::shared_ptr<WebSocket> open_web_socket(
    boost::asio::ip::tcp::socket socket,
    const boost::beast::http::request<boost::beast::http::string_body>& request);

}  // namespace sim
