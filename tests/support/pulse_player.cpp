#include "tests/support/pulse_player.hpp"

#include <memory>

#include "tests/support/let_in.hpp"

namespace proof {

bool play(const std::vector<cnc::motion::Segment>& segments,
          const cnc::StepTiming& timing,
          EdgeSink& sink) {
  PulsePort port{sink, timing};
  using Generator = cnc::StepGenerator<PulsePort, 8>;
  const auto generator = std::make_unique<Generator>(port);
  generator->set_timing(timing);
  std::size_t next = 0;
  const auto refill = [&] {
    while (next < segments.size() && !generator->full()) generator->push(segments[next++]);
  };
  refill();
  let_in(*generator);
  while (generator->running()) {
    port.now += generator->player().on_interrupt();
    refill();
    let_in(*generator);
  }
  return port.timing_kept();
}

}  // namespace proof
