#pragma once

#include <sys/resource.h>
#include <unistd.h>

namespace sim {

/// Lowers the priority of this thread, so that the server's loop runs first on a machine with few
/// processors. If the system refuses that, the loop may be slower.
inline void work_in_background() {
  constexpr int kNice = 10;
  static_cast<void>(::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice));
}

}  // namespace sim
