#include "tests/support/drive.hpp"

#include <memory>
#include <stdexcept>

#include "planner/path/path_stage.hpp"

namespace proof {
namespace {

using cnc::motion::BlockQueueOf;
using cnc::motion::kLookAheadBlocks;
using cnc::motion::Segment;
using cnc::motion::Segmenter;

class Driver {
 public:
  Driver(const Program& program, const TestMachine& machine, const Operator& operate)
      : program_{program}, machine_{machine}, operate_{operate} {
    segmenter_.observe(&plan_);
  }

  RecordedPlan run() {
    while (next_ < program_.items.size() || !stage_.empty() || !segmenter_.idle()) {
      const std::size_t before = progress();
      for (std::size_t i = 0; i < program_.pushed_at_once && may_push(); ++i) push();
      pump();
      if (stage_.empty() && waits_for_rest()) queue_.expect_no_more();
      for (std::size_t i = 0; i < program_.cut_at_once && cut(); ++i) {
      }
      if (!operate_ && progress() == before && ++idle_turns_ > kMaxIdleTurns) {
        throw std::logic_error("the motion stands still before its end");
      }
    }
    return std::move(plan_);
  }

 private:
  [[nodiscard]] std::size_t progress() const {
    return next_ + plan_.slices.size() + plan_.blocks.size();
  }

  /// Returns whether nothing more arrives until the machine is at rest.
  [[nodiscard]] bool waits_for_rest() const {
    return next_ == program_.items.size() || program_.items[next_].stop_before;
  }

  bool may_push() {
    pump();
    if (next_ == program_.items.size()) {
      stage_.flush();
      return false;
    }
    if (queue_.full() || !stage_.has_room()) return false;
    if (!program_.items[next_].stop_before) return true;
    stage_.flush();
    pump();
    return stage_.empty() && segmenter_.idle();
  }

  void push() {
    const cnc::motion::MotionRequest& request = program_.items[next_++].request;
    if (request.element.start == request.element.end) return;
    const float tolerance = machine_.limits.junction_deviation_mm;
    stage_.put(
        {.request = request, .tolerance = {.corner_mm = tolerance, .weld_mm = program_.weld_mm}});
  }

  void pump() {
    while (!queue_.full()) {
      const cnc::path::PathPiece* const next = stage_.next();
      if (next == nullptr) return;
      const cnc::path::PathPiece& piece = *next;
      const auto block = build_block(piece.request, machine_.limits);
      const bool from_rest = segmenter_.idle() || piece.joint == cnc::motion::Joint::kStop;
      if (!block.ok()) {
        if (block.error() == cnc::motion::MotionError::kNothingToMove) continue;
        throw std::logic_error("a block that cannot be built");
      }
      queue_.push(block.value(), piece.joint);
      const cnc::PathElement& element = piece.request.element;
      plan_.blocks.push_back({block.value(), ExactBlock{element}, element.end, from_rest, element});
    }
  }

  bool cut() {
    if (operate_) operate_(segmenter_, plan_.segments.size());
    Segment segment;
    if (!segmenter_.next(segment)) return false;
    plan_.segments.push_back(segment);
    if (plan_.segments.size() > kMaxSegments) throw std::logic_error("the motion does not end");
    return true;
  }

  static constexpr std::size_t kMaxSegments = 3'000'000;
  static constexpr int kMaxIdleTurns = 1000;

  const Program& program_;
  const TestMachine& machine_;
  const Operator& operate_;
  RecordedPlan plan_{};
  BlockQueueOf<kLookAheadBlocks> queue_{};
  Segmenter segmenter_{queue_, machine_.limits};
  cnc::path::PathStage stage_{machine_.limits};
  std::size_t next_ = 0;
  /// Number of successive cycles in which only held-back elements were evaluated.
  int idle_turns_ = 0;
};

}  // namespace

RecordedPlan drive(const Program& program, const TestMachine& machine, const Operator& operate) {
  return std::make_unique<Driver>(program, machine, operate)->run();
}

}  // namespace proof
