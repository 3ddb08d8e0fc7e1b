#pragma once

#include <sys/resource.h>
#include <unistd.h>

namespace sim {

/// Lets the loop of the server go before this thread where processors are few. A system that
/// refuses it costs nothing but time.
inline void work_in_background() {
  constexpr int kNice = 10;
  static_cast<void>(::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice));
}

}  // namespace sim
