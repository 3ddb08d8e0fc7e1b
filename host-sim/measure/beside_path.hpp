#pragma once

#include <memory>
#include <optional>

#include "host-sim/measure/programmed_path.hpp"
#include "planner/compensation/compensator.hpp"

namespace sim {

/// Passes the pieces of a path on one by one, those between G41 or G42 and G40 through the
/// product's compensator; see beside_path().
class BesideWay {
 public:
  explicit BesideWay(PieceSink sink) : sink_{std::move(sink)} {}

  void put(const PathPiece& piece);
  /// There are no more.
  void end();
  /// The first motion that could not be driven beside the programmed path.
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
  std::optional<Point> last_end_{};  ///< Of the last piece that was passed on.
  bool stops_ = false;
  bool drops_ = false;  ///< What was refused is left out until the path ends.
  std::optional<RefusedBeside> refused_{};
};

/// Where a program's path leads when G41 and G42 are done: half the width beside what is
/// programmed, as the product's compensator has it (planner/compensation), with entry and exit.
/// A path without them stays as it is. What cannot be driven the machine refuses; here the path
/// goes on straight from the last element that can, and `refused` has the lines.
[[nodiscard]] ProgrammedPath beside_path(ProgrammedPath programmed);

}  // namespace sim
