#include "host-sim/serve/byte_blocks.hpp"

#include <algorithm>
#include <utility>

namespace sim {

ByteBlocks::ByteBlocks() : ready_(kReady, Block(kBlock)) {}

void ByteBlocks::append(std::span<const char> bytes) {
  while (!bytes.empty()) {
    const std::size_t end = begin_ + size_;
    if (end == blocks_.size() * kBlock) {
      if (ready_.empty()) ready_.emplace_back(kBlock);
      blocks_.push_back(std::move(ready_.back()));
      ready_.pop_back();
    }
    const std::size_t place = end % kBlock;
    const std::size_t count = std::min(bytes.size(), kBlock - place);
    std::copy_n(bytes.begin(), count, blocks_.back().data() + place);
    bytes = bytes.subspan(count);
    size_ += count;
  }
}

std::span<const char> ByteBlocks::front() const {
  if (size_ == 0) return {};
  return {blocks_.front().data() + begin_, std::min(size_, kBlock - begin_)};
}

void ByteBlocks::pop(std::size_t count) {
  begin_ += count;
  size_ -= count;
  if (size_ == 0) {
    begin_ = 0;  // The single block of an empty queue is kept.
  } else if (begin_ == kBlock) {
    begin_ = 0;
    give_back(std::move(blocks_.front()));
    blocks_.pop_front();
  }
}

void ByteBlocks::give_back(Block block) {
  if (ready_.size() < kReady) ready_.push_back(std::move(block));
}

void ByteBlocks::clear() {
  for (Block& block : std::exchange(blocks_, {})) give_back(std::move(block));
  begin_ = 0;
  size_ = 0;
}

std::string ByteBlocks::text() const {
  std::string text;
  text.reserve(size_);
  std::size_t begin = begin_;
  for (const Block& block : blocks_) {
    text.append(block.data() + begin, std::min(size_ - text.size(), kBlock - begin));
    begin = 0;
  }
  return text;
}

}  // namespace sim
