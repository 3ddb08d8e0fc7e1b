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

/// Status and headers of an answer, after which the connection ends; with `content`, unless only
/// the head was asked for.
[[nodiscard]] std::string web_answer(const WebReply& reply, bool only_head);

/// A sentence for people.
[[nodiscard]] WebReply web_refusal(int status, std::string_view reason);

}  // namespace sim
