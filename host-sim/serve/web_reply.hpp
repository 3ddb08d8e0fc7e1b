#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace sim {

/// The answer to a request.
struct WebReply {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string content;
};

/// Function that makes a reply in a separate thread. It must use only data that it holds itself.
using WebWork = std::function<WebReply()>;

/// Returns a refusal whose content is a sentence for the user.
[[nodiscard]] inline WebReply web_refusal(int status, std::string_view reason) {
  return {.status = status, .content = std::string{reason}};
}

}  // namespace sim
