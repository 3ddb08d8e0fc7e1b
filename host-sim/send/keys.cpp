#include "host-sim/send/keys.hpp"

#include <poll.h>
#include <unistd.h>

namespace sim {

Keys::Keys() {
  termios mode{};
  if (::isatty(STDIN_FILENO) == 0 || ::tcgetattr(STDIN_FILENO, &mode) != 0) return;
  // The system would stop a process in the background that changes the mode of the terminal.
  if (::tcgetpgrp(STDIN_FILENO) != ::getpgrp()) return;
  before_ = mode;
  mode.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  ::tcsetattr(STDIN_FILENO, TCSANOW, &mode);
}

Keys::~Keys() {
  if (before_) ::tcsetattr(STDIN_FILENO, TCSANOW, &*before_);
}

std::optional<char> Keys::take() {
  if (!before_) return std::nullopt;
  pollfd state{STDIN_FILENO, POLLIN, 0};
  if (::poll(&state, 1, 0) <= 0 || (state.revents & POLLIN) == 0) return std::nullopt;
  char key = 0;
  if (::read(STDIN_FILENO, &key, 1) != 1) return std::nullopt;
  return key;
}

}  // namespace sim
