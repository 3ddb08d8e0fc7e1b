#pragma once

#include <optional>
#include <string>

#include "host-sim/cli/input_files.hpp"
#include "host-sim/post/post.hpp"

namespace CLI {
class App;
}

namespace sim {

/// The form in which a command that makes programs writes them.
class PostOption {
 public:
  /// Adds `--post`.
  void add_to(CLI::App& command);

  /// Reads the file where there is one, and keeps its digest. Positions get no more decimals than
  /// the post has. Throws as read_text() and read_post() do, and std::invalid_argument where
  /// `--decimals` asks for more.
  void read(const CLI::App& command, InputFiles& inputs, unsigned& decimals);

  /// Returns whether the call names a file.
  [[nodiscard]] bool is_asked() const { return !file_.empty(); }

  /// Returns whether arcs of a plane stay arcs.
  [[nodiscard]] bool knows_arcs(cnc::Plane plane) const {
    return !post_ || post_->knows_arcs(plane);
  }
  /// Returns a program as the file wants it; without one as it is.
  [[nodiscard]] std::string applied_to(std::string program) const;

 private:
  std::string file_;
  std::optional<post::Post> post_;
};

}  // namespace sim
