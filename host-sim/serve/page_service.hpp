#pragma once

#include <optional>
#include <variant>

#include "host-sim/serve/http_request.hpp"
#include "host-sim/serve/web_reply.hpp"

namespace sim {

/// Answers what a page asks for. In the loop's thread; what takes time is left to the work.
class PageService {
 public:
  using Answer = std::variant<WebReply, WebWork>;

  /// Why a request is refused, by its head alone; nothing when its body may be read.
  [[nodiscard]] virtual std::optional<WebReply> refusal(const HttpRequest& request) const = 0;
  /// The answer to a request that was not refused.
  [[nodiscard]] virtual Answer answer(HttpRequest request) = 0;

 protected:
  ~PageService() = default;
};

}  // namespace sim
