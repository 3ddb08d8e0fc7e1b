#include "host-sim/serve/outline_request.hpp"

#include <civetweb.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "host-sim/serve/web_answer.hpp"

namespace sim {
namespace {

constexpr int kBadRequest = 400;
constexpr int kWrongMethod = 405;
constexpr int kLengthRequired = 411;
constexpr int kTooLarge = 413;
constexpr int kTooBusy = 503;
constexpr long long kLongestProgram = 64LL << 20;
constexpr std::size_t kBodyPart = std::size_t{64} << 10;

/// As much of the announced body as comes; memory grows with what is there.
std::string read_body(mg_connection* connection, std::size_t length) {
  std::string body;
  while (body.size() < length) {
    const std::size_t before = body.size();
    body.resize(std::min(length, before + kBodyPart));
    const int count = mg_read(connection, body.data() + before, body.size() - before);
    body.resize(before + static_cast<std::size_t>(std::max(count, 0)));
    if (count <= 0) break;
  }
  return body;
}

}  // namespace

int answer_outline(mg_connection* connection, PageService& service) {
  const mg_request_info* request = mg_get_request_info(connection);
  if (request->request_method != std::string_view{"POST"}) {
    return send_refusal(connection, kWrongMethod, "A program is sent here with POST.");
  }
  const long long length = request->content_length;
  if (length < 0) {
    return send_refusal(connection, kLengthRequired, "The length of the program is not given.");
  }
  if (length > kLongestProgram) {
    return send_refusal(connection, kTooLarge, "A program of more than 64 MiB is not drawn.");
  }
  const auto size = static_cast<std::size_t>(length);
  const std::string program = read_body(connection, size);
  if (program.size() < size)
    return send_refusal(connection, kBadRequest, "The program is not all there.");
  const auto outline = service.outline(program);
  if (!outline) return send_refusal(connection, kTooBusy, "The controller does not answer.");
  return send_document(connection, outline->type, outline->content);
}

}  // namespace sim
