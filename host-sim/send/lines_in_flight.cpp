#include "host-sim/send/lines_in_flight.hpp"

#include <algorithm>

namespace sim {

void LinesInFlight::send(std::size_t bytes) {
  sizes_.push_back(bytes);
  bytes_ += bytes;
  furthest_ = std::max(furthest_, ++next_);
}

void LinesInFlight::answer_until(std::size_t line) {
  for (; answered_ < line && !sizes_.empty(); ++answered_) {
    bytes_ -= sizes_.front();
    sizes_.pop_front();
  }
  answered_ = line;
  next_ = std::max(next_, answered_);
}

void LinesInFlight::go_back(std::size_t line) {
  resent_ += next_ - line;
  for (; next_ > line; --next_) {
    bytes_ -= sizes_.back();
    sizes_.pop_back();
  }
}

}  // namespace sim
