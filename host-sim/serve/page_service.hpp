#pragma once

#include <string>

namespace sim {

/// Answers what a page asks for, in the threads of the web server.
class PageService {
 public:
  struct Document {
    std::string type;
    std::string content;
  };
  /// The picture of the motion so far. May wait for the loop, but not for long.
  [[nodiscard]] virtual Document picture() = 0;

 protected:
  ~PageService() = default;
};

}  // namespace sim
