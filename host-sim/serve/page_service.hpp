#pragma once

#include <optional>
#include <string>
#include <string_view>

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

  /// Where a program would go if it were sent now; nothing when the loop does
  /// not answer. May take seconds for a large program.
  [[nodiscard]] virtual std::optional<Document> outline(std::string_view program) = 0;

 protected:
  ~PageService() = default;
};

}  // namespace sim
