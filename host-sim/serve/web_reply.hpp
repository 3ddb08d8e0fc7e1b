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

/// Makes a reply in a thread of its own. It must use no data other than those that it holds.
using WebWork = std::function<WebReply()>;

/// Returns a refusal with a sentence for people.
[[nodiscard]] inline WebReply web_refusal(int status, std::string_view reason) {
  return {.status = status, .content = std::string{reason}};
}

}  // namespace sim
