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
  std::string path;                            ///< Decoded, without the query.
  std::map<std::string, std::string> query;    ///< Decoded.
  std::map<std::string, std::string> headers;  ///< By names in lower case.
  std::string body;

  /// The value of a header, named in lower case; empty when it is missing.
  [[nodiscard]] std::string_view header(std::string_view name) const;
  /// Whether a header's list holds this word, in any case.
  [[nodiscard]] bool lists(std::string_view name, std::string_view word) const;
  [[nodiscard]] bool wants_web_socket() const { return lists("upgrade", "websocket"); }
  /// Nothing when the length is missing, or is no number.
  [[nodiscard]] std::optional<std::size_t> content_length() const;
};

/// Reads the head of a request: all up to the empty line, without it. Nothing when it is
/// malformed; a header that stands twice is, because two readers could take different ones.
[[nodiscard]] std::optional<HttpRequest> parse_http_head(std::string_view head);

/// The text in lower case, ASCII only.
[[nodiscard]] std::string lower_case(std::string_view text);

}  // namespace sim
