#pragma once

#include <cstdint>
#include <vector>

#include "firmware/steps/step_generator.hpp"
#include "tests/support/recorded_plan.hpp"

namespace proof {

/// Leading edge of the step pulses of some axes.
struct Edge {
  std::uint64_t tick = 0;
  std::uint8_t axes = 0;
  std::uint8_t negative = 0;
};

class EdgeSink {
 public:
  virtual void on_edge(const Edge& edge) = 0;

 protected:
  ~EdgeSink() = default;
};

/// A step port that passes edges on to a sink and checks the electrical timing.
class PulsePort {
 public:
  PulsePort(EdgeSink& sink, const cnc::StepTiming& timing) : sink_{&sink}, timing_{timing} {}

  void set_direction(hal::AxisMask negative) noexcept {
    kept_ &= !high_;
    negative_ = negative.bits;
    direction_changed_ = now;
  }
  void raise_steps(hal::AxisMask axes, hal::AxisMask) noexcept {
    kept_ &= !high_ && now >= lowered_ + (ever_lowered_ ? timing_.pulse : 0);
    kept_ &= now >= direction_changed_ + (negative_ != 0 ? timing_.direction_set_up : 0);
    high_ = true;
    raised_ = now;
    sink_->on_edge({now, axes.bits, negative_});
  }
  void lower_steps() noexcept {
    kept_ &= high_ && now >= raised_ + timing_.pulse;
    high_ = false;
    ever_lowered_ = true;
    lowered_ = now;
  }
  void set_power(std::uint16_t) noexcept {}
  void change_outputs(std::uint8_t, std::uint8_t) noexcept {}
  void set_analog(std::uint8_t, std::uint16_t) noexcept {}
  void start_timer() noexcept {}
  [[nodiscard]] bool probe_contact() noexcept { return false; }
  [[nodiscard]] hal::SwitchMask switches() noexcept { return {}; }

  [[nodiscard]] bool timing_kept() const { return kept_; }

  std::uint64_t now = 0;  ///< Present time, ticks of the step clock.

 private:
  EdgeSink* sink_;
  cnc::StepTiming timing_;
  std::uint8_t negative_ = 0;
  bool high_ = false;
  bool kept_ = true;
  bool ever_lowered_ = false;
  std::uint64_t raised_ = 0;
  std::uint64_t lowered_ = 0;
  std::uint64_t direction_changed_ = 0;
};

/// Plays segments without a pause between them. Returns whether pulse width and direction set-up
/// satisfied `timing`.
[[nodiscard]] bool play(const std::vector<cnc::motion::Segment>& segments,
                        const cnc::StepTiming& timing,
                        EdgeSink& sink);

}  // namespace proof
