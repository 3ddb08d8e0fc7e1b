#include "host-sim/serve/http_request.hpp"

#include <algorithm>
#include <charconv>

namespace sim {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// Takes the part before `mark` off the front, and the mark.
std::string_view take_to(std::string_view& text, std::string_view mark) {
  const std::size_t end = std::min(text.find(mark), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + mark.size(), text.size()));
  return part;
}

/// `%41` is A. Nothing when a digit is missing.
std::optional<std::string> decoded(std::string_view text) {
  std::string plain;
  for (; !text.empty(); text.remove_prefix(1)) {
    if (text.front() != '%') {
      plain += text.front();
      continue;
    }
    unsigned byte = 0;
    const char* digits = text.data() + 1;
    if (text.size() < 3) return {};
    if (std::from_chars(digits, digits + 2, byte, 16).ptr != digits + 2) return {};
    plain += static_cast<char>(byte);
    text.remove_prefix(2);
  }
  return plain;
}

constexpr std::string_view kTokenMarks = "!#$%&'*+-.^_`|~";

bool is_token(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    return letter || (c >= '0' && c <= '9') || kTokenMarks.find(c) != std::string_view::npos;
  });
}

bool has_control_bytes(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < ' ' && c != '\t';
  });
}

bool read_target(std::string_view target, HttpRequest& request) {
  if (!target.starts_with('/')) return false;
  const auto path = decoded(take_to(target, "?"));
  if (!path) return false;
  request.path = *path;
  while (!target.empty()) {
    std::string_view value = take_to(target, "&");
    const auto name = decoded(take_to(value, "="));
    const auto meant = decoded(value);
    if (!name || !meant) return false;
    request.query[*name] = *meant;
  }
  return true;
}

bool read_first_line(std::string_view line, HttpRequest& request) {
  request.method = take_to(line, " ");
  const std::string_view target = take_to(line, " ");
  return is_token(request.method) && (line == "HTTP/1.1" || line == "HTTP/1.0") &&
         read_target(target, request);
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string lower{text};
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::string_view HttpRequest::header(std::string_view name) const {
  const auto found = headers.find(std::string{name});
  return found == headers.end() ? std::string_view{} : std::string_view{found->second};
}

bool HttpRequest::lists(std::string_view name, std::string_view word) const {
  std::string_view rest = header(name);
  while (!rest.empty()) {
    if (lower_case(trimmed(take_to(rest, ","))) == word) return true;
  }
  return false;
}

std::optional<std::size_t> HttpRequest::content_length() const {
  const std::string_view text = header("content-length");
  std::size_t length = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), length);
  if (text.empty() || fault != std::errc{} || end != text.data() + text.size()) return {};
  return length;
}

std::optional<HttpRequest> parse_http_head(std::string_view head) {
  HttpRequest request;
  if (!read_first_line(take_to(head, "\r\n"), request)) return {};
  while (!head.empty()) {
    std::string_view line = take_to(head, "\r\n");
    if (line.find(':') == std::string_view::npos || has_control_bytes(line)) return {};
    const std::string_view name = take_to(line, ":");
    if (!is_token(name)) return {};
    if (!request.headers.emplace(lower_case(name), trimmed(line)).second) return {};
  }
  return request;
}

}  // namespace sim
