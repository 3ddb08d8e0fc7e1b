#include "host-sim/serve/web_answer.hpp"

#include <civetweb.h>
#include <fmt/format.h>

#include <string>

namespace sim {
namespace {

constexpr int kFine = 200;
// Nothing from elsewhere, nothing inline, in nobody's frame.
constexpr std::string_view kPolicy =
    "default-src 'self'; img-src 'self' blob: data:; object-src 'none'; base-uri 'none'; "
    "frame-ancestors 'none'";

int send(mg_connection* connection, int status, std::string_view type, std::string_view content) {
  const std::string head = fmt::format(
      "HTTP/1.1 {} {}\r\nContent-Type: {}\r\nContent-Length: {}\r\nCache-Control: no-cache\r\n"
      "Connection: close\r\nX-Content-Type-Options: nosniff\r\nContent-Security-Policy: {}\r\n\r\n",
      status,
      mg_get_response_code_text(connection, status),
      type,
      content.size(),
      kPolicy);
  mg_write(connection, head.data(), head.size());
  mg_write(connection, content.data(), content.size());
  return status;
}

}  // namespace

int send_document(mg_connection* connection, std::string_view type, std::string_view content) {
  return send(connection, kFine, type, content);
}

int send_refusal(mg_connection* connection, int status, std::string_view reason) {
  return send(connection, status, "text/plain; charset=utf-8", reason);
}

}  // namespace sim
