#pragma once

#include <memory>
#include <optional>

#include "host-sim/measure/programmed_path.hpp"
#include "planner/compensation/compensator.hpp"

namespace sim {

/// Passes the pieces of a path on, one by one. Pieces between G41 or G42 and G40 first go through
/// the product's compensator; see beside_path().
class BesideWay {
 public:
  explicit BesideWay(PieceSink sink) : sink_{std::move(sink)} {}

  void put(const PathPiece& piece);
  /// Ends the path. No pieces may follow.
  void end();
  /// Returns the first motion that cannot be driven offset from the programmed path.
  [[nodiscard]] const std::optional<RefusedBeside>& refused() const { return refused_; }

 private:
  void leave(const PathPiece& piece);
  void go_back(const PathPiece& piece, const cnc::Position& to);
  void refuse(const std::optional<cnc::compensation::Fault>& fault, int line);
  void take();
  void pass_on(const PathPiece& piece);

  PieceSink sink_;
  std::unique_ptr<cnc::compensation::Compensator> compensator_ =
      std::make_unique<cnc::compensation::Compensator>();
  std::optional<Point> last_end_{};  ///< End of the last piece that was passed on.
  bool stops_ = false;
  /// Whether pieces are dropped until the path ends, because a piece was refused.
  bool drops_ = false;
  std::optional<RefusedBeside> refused_{};
};

/// Returns the path of a program with G41 and G42 applied. It is offset from the programmed path by
/// half the width of the tool or the cut, with entry and exit, as the product's compensator
/// computes it (planner/compensation). A path without G41 and G42 stays unchanged. The machine
/// refuses elements that cannot be driven. Here, the path instead continues straight from the last
/// element that can be driven, and `refused` contains the line numbers.
[[nodiscard]] ProgrammedPath beside_path(ProgrammedPath programmed);

}  // namespace sim
