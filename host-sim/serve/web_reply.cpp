#include "host-sim/serve/web_reply.hpp"

#include <fmt/format.h>

namespace sim {
namespace {

// Nothing from elsewhere, nothing inline, in nobody's frame.
constexpr std::string_view kPolicy =
    "default-src 'self'; img-src 'self' blob: data:; object-src 'none'; base-uri 'none'; "
    "frame-ancestors 'none'";

std::string_view name_of(int status) {
  switch (status) {
    case 200:
      return "OK";
    case 400:
      return "Bad Request";
    case 403:
      return "Forbidden";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    case 408:
      return "Request Timeout";
    case 409:
      return "Conflict";
    case 411:
      return "Length Required";
    case 413:
      return "Content Too Large";
    case 426:
      return "Upgrade Required";
    case 431:
      return "Request Header Fields Too Large";
    case 503:
      return "Service Unavailable";
    default:
      return "Internal Server Error";
  }
}

}  // namespace

std::string web_answer(const WebReply& reply, bool only_head) {
  std::string answer = fmt::format(
      "HTTP/1.1 {} {}\r\nContent-Type: {}\r\nContent-Length: {}\r\nCache-Control: no-cache\r\n"
      "Connection: close\r\nX-Content-Type-Options: nosniff\r\nContent-Security-Policy: {}\r\n{}"
      "\r\n",
      reply.status,
      name_of(reply.status),
      reply.type,
      reply.content.size(),
      kPolicy,
      reply.status == 405 ? "Allow: GET, HEAD, POST\r\n" : "");
  if (!only_head) answer += reply.content;
  return answer;
}

WebReply web_refusal(int status, std::string_view reason) {
  return {.status = status, .content = std::string{reason}};
}

}  // namespace sim
