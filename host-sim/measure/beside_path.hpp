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

 private:
  void leave(const PathPiece& piece);
  void take();
  void pass_on(const PathPiece& piece);

  PieceSink sink_;
  std::unique_ptr<cnc::compensation::Compensator> compensator_ =
      std::make_unique<cnc::compensation::Compensator>();
  std::optional<Point> last_end_{};  ///< Of the last piece that was passed on.
  bool stops_ = false;
  bool refused_ = false;
};

/// Where a program's path leads when G41 and G42 are done: half the width beside what is
/// programmed, as the product's compensator has it (planner/compensation), with entry and exit.
/// A path without them stays as it is. What cannot be driven the machine refuses; here the path
/// goes on straight from the last element that can.
[[nodiscard]] ProgrammedPath beside_path(ProgrammedPath programmed);

}  // namespace sim
