#pragma once

#include <optional>
#include <string>

#include "host-sim/cli/input_files.hpp"
#include "host-sim/post/post.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Option for the form in which a command writes programs.
class PostOption {
 public:
  /// Adds `--post`.
  void add_to(CLI::App& command);

  /// Reads the post if the call names its file, and keeps its digest. Limits the decimals of
  /// positions to those of the post. Throws as read_text() and read_post() do, and
  /// std::invalid_argument if `--decimals` requires more decimals.
  void read(const CLI::App& command, InputFiles& inputs, unsigned& decimals);

  /// Returns whether the call names a file.
  [[nodiscard]] bool is_asked() const { return !file_.empty(); }

  /// Returns whether the controller accepts arcs in a plane.
  [[nodiscard]] bool knows_arcs(cnc::Plane plane) const {
    return !post_ || post_->knows_arcs(plane);
  }
  /// Returns a program in the form of the post; unchanged without a post.
  [[nodiscard]] std::string applied_to(std::string program) const;

 private:
  std::string file_;
  std::optional<post::Post> post_;
};

}  // namespace sim
