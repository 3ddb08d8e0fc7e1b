#include "tests/support/drive.hpp"

#include <memory>
#include <stdexcept>

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
    while (next_ < program_.items.size() || !segmenter_.idle()) {
      const std::size_t before = next_ + plan_.slices.size();
      for (std::size_t i = 0; i < program_.pushed_at_once && may_push(); ++i) push();
      for (std::size_t i = 0; i < program_.cut_at_once && cut(); ++i) {
      }
      if (!operate_ && next_ + plan_.slices.size() == before) {
        throw std::logic_error("the motion stands still before its end");
      }
    }
    return std::move(plan_);
  }

 private:
  bool may_push() {
    if (next_ == program_.items.size() || queue_.full()) return false;
    return !program_.items[next_].stop_before || segmenter_.idle();
  }

  void push() {
    const auto block = build_block(program_.items[next_].request, machine_.limits);
    const bool from_rest = segmenter_.idle();
    ++next_;
    if (!block.ok()) {
      if (block.error() == cnc::motion::MotionError::kNothingToMove) return;
      throw std::logic_error("a block that cannot be built");
    }
    queue_.push(block.value(), machine_.limits);
    const cnc::PathElement& element = program_.items[next_ - 1].request.element;
    plan_.blocks.push_back({block.value(), ExactBlock{element}, element.end, from_rest});
  }

  bool cut() {
    if (operate_) operate_(segmenter_, plan_.segments.size());
    Segment segment;
    if (!segmenter_.next(segment)) return false;
    plan_.segments.push_back(segment);
    if (plan_.segments.size() > kMostSegments) throw std::logic_error("the motion does not end");
    return true;
  }

  static constexpr std::size_t kMostSegments = 3'000'000;

  const Program& program_;
  const TestMachine& machine_;
  const Operator& operate_;
  RecordedPlan plan_{};
  BlockQueueOf<kLookAheadBlocks> queue_{};
  Segmenter segmenter_{queue_, machine_.limits};
  std::size_t next_ = 0;
};

}  // namespace

RecordedPlan drive(const Program& program, const TestMachine& machine, const Operator& operate) {
  return std::make_unique<Driver>(program, machine, operate)->run();
}

}  // namespace proof
