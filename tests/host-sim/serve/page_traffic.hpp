#pragma once

#include <atomic>
#include <string>
#include <thread>

#include "host-sim/serve/internet_address.hpp"

namespace sim {

/// Pages that keep a server busy while this object lives. One watches the machine. Another one
/// reads the page and the picture, and sends programs to be outlined and judged.
class PageTraffic {
 public:
  explicit PageTraffic(InternetAddress address);
  PageTraffic(const PageTraffic&) = delete;
  PageTraffic& operator=(const PageTraffic&) = delete;
  ~PageTraffic();

  /// Numbers of answered requests, and of bytes of news.
  [[nodiscard]] unsigned answered() const { return answered_; }
  [[nodiscard]] std::size_t news() const { return news_; }

 private:
  void ask();
  void watch();

  InternetAddress address_;
  std::atomic<bool> ends_{false};
  std::atomic<unsigned> answered_{0};
  std::atomic<std::size_t> news_{0};
  std::thread asking_;
  std::thread watching_;
};

}  // namespace sim
