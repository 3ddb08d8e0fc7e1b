#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace sim {

/// What a request is answered with.
struct WebReply {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string content;
};

/// Makes a reply, in a thread of its own: it must touch nothing but what it holds.
using WebWork = std::function<WebReply()>;

/// A sentence for people.
[[nodiscard]] inline WebReply web_refusal(int status, std::string_view reason) {
  return {.status = status, .content = std::string{reason}};
}

}  // namespace sim
