#pragma once

#include <optional>
#include <variant>

#include "host-sim/serve/http_request.hpp"
#include "host-sim/serve/web_reply.hpp"

namespace sim {

/// Answers the requests of a page in the thread of the server loop. Work that takes long is
/// returned as WebWork, for another thread.
class PageService {
 public:
  using Answer = std::variant<WebReply, WebWork>;

  /// Returns the refusal of a request, which depends only on its head; nothing if the body may be
  /// read.
  [[nodiscard]] virtual std::optional<WebReply> refusal(const HttpRequest& request) const = 0;
  /// Returns the answer to a request that was not refused.
  [[nodiscard]] virtual Answer answer(HttpRequest request) = 0;

 protected:
  ~PageService() = default;
};

}  // namespace sim
