#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace sim {

/// A request of HTTP/1.1, as far as the page and its scripts need it (RFC 9112).
struct HttpRequest {
  std::string method;
  std::string path;                          ///< Decoded, without the query.
  std::map<std::string, std::string> query;  ///< Decoded.
  std::string host;                          ///< As the client named this server; may be empty.
  std::string origin;                        ///< Of the page that asks; empty for none.
  std::optional<std::size_t> length;         ///< Of the body, where the head announces it.
  bool wants_web_socket = false;
  std::string body;
};

/// Reads path and query of a request's target. False when the target is no path, or an escape
/// such as `%41` is malformed.
[[nodiscard]] bool read_target(std::string_view target, HttpRequest& request);

}  // namespace sim
