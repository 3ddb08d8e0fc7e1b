#include "firmware/machine/memory_watch.hpp"

#include <algorithm>

#include "planner/base/contract.hpp"

namespace cnc {

void MemoryWatch::add(Part part) {
  CNC_ASSERT(count_ < kMaxParts);
  parts_[count_++] = part;
}

void MemoryWatch::expect(std::uint32_t checksum) {
  expected_ = checksum;
  begin_round();
}

bool MemoryWatch::check(std::size_t bytes) {
  std::size_t left = bytes;
  while (left > 0 && part_ < count_) {
    const Part rest = parts_[part_].subspan(place_);
    const std::size_t taken = std::min(left, rest.size());
    sum_.add(rest.first(taken));
    left -= taken;
    place_ += taken;
    if (taken < rest.size()) return true;
    ++part_;
    place_ = 0;
  }
  if (part_ < count_) return true;
  const bool same = sum_.value() == expected_;
  begin_round();
  return same;
}

std::uint32_t MemoryWatch::checksum() const {
  Crc32 sum;
  for (std::size_t part = 0; part < count_; ++part) sum.add(parts_[part]);
  return sum.value();
}

void MemoryWatch::begin_round() {
  sum_ = {};
  part_ = 0;
  place_ = 0;
}

}  // namespace cnc
