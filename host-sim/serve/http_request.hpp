#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace sim {

/// A request of HTTP/1.1 (RFC 9112), with the fields that this server uses.
struct HttpRequest {
  std::string method;
  std::string path;                          ///< Decoded path, without the query.
  std::map<std::string, std::string> query;  ///< Decoded names and values of the query.
  std::string host;    ///< Name of this server in the header Host; may be empty.
  std::string origin;  ///< Origin of the requesting page; empty for none.
  /// Length of the body in bytes; empty if the head does not give it.
  std::optional<std::size_t> length;
  bool wants_web_socket = false;
  std::string body;
};

/// Reads path and query of a request's target. Returns false if the target is not a path, or if an
/// escape such as `%41` is malformed.
[[nodiscard]] bool read_target(std::string_view target, HttpRequest& request);

}  // namespace sim
