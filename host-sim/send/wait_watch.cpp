#include "host-sim/send/wait_watch.hpp"

#include <fmt/format.h>

namespace sim {
namespace {

std::string_view awaited_in(std::string_view state) {
  if (state.starts_with("Hold")) {
    return "held, by M0, `!` or the feed hold button: cycle start (`~`) goes on";
  }
  if (state.starts_with("Tool"))
    return "a tool is to be changed (M6): then cycle start (`~`) goes on";
  if (state.starts_with("Door"))
    return "the safety door was opened: close it, then cycle start (`~`) goes on";
  return {};
}

}  // namespace

std::string WaitWatch::attend(std::string_view state, std::size_t line, Time now) {
  const std::string_view awaited = awaited_in(state);
  const std::string_view name = state.substr(0, state.find(':'));
  if (awaited.empty()) {
    waits_in_.clear();
    return {};
  }
  if (waits_in_ != name) {
    waits_in_ = name;
    since_ = now;
    told_ = false;
  }
  if (told_ || now - since_ < kPatience) return {};
  told_ = true;
  return line == 0 ? fmt::format("waits: {}", awaited)
                   : fmt::format("waits before line {}: {}", line, awaited);
}

}  // namespace sim
