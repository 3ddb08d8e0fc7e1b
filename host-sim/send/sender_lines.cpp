#include <fmt/format.h>

#include <algorithm>

#include "firmware/link/receiver.hpp"
#include "host-sim/send/sender.hpp"

namespace sim {
namespace {

constexpr std::size_t kGrblRoom = 128;
/// On a serial line at 115,200 baud these bytes take 22 ms, which is longer than adapters delay
/// answers.
constexpr std::size_t kCheckedWindow = 256;

}  // namespace

void Sender::ask() {
  ++questions_;
  asked_ = now_;
  answers_owed_ += 2;
  put("");  // Ends a line that another sender has begun.
  put("$I");
}

void Sender::begin() {
  ++questions_;
  asked_ = now_;
  // Only Kerfline knows checked lines, so its buffer size is known. The size that it announced may
  // be damaged.
  room_ = cnc::Receiver::kAdvertisedBytes;
  begun_ = answered_;
  const std::uint32_t n = begun_ < job_.size() ? job_[begun_].n : 1U;
  first_n_ = n <= options_.max_number ? std::max(1U, n) : 1U;
  put(with_crc(fmt::format("N{}M110", first_n_ - 1)));
}

void Sender::send_end() {
  ++questions_;
  asked_ = now_;
  put(with_crc("M110"));
}

std::size_t Sender::window() const {
  if (options_.window != 0) return options_.window;
  if (options_.checked) return kCheckedWindow;
  return room_ != 0 ? room_ : kGrblRoom;
}

std::string Sender::text_of(std::size_t line) const {
  const auto [text, number, n] = job_[line];
  if (numbers_lines_) return with_crc(fmt::format("N{}{}", number_of(line), text));
  return n == 0 || text.starts_with('$') ? text : fmt::format("N{}{}", n, text);
}

std::uint32_t Sender::number_of(std::size_t line) const {
  return first_n_ + static_cast<std::uint32_t>(line - begun_);
}

void Sender::send_lines() {
  if (state_ != State::kSending) return;
  while (next_ < job_.size()) {
    if (numbers_lines_ && number_of(next_) > options_.max_number) break;
    std::string line = text_of(next_);
    // A line that is longer than the window is sent alone.
    const std::size_t size = line.size() + 1;
    if (next_ != answered_ && on_their_way_ + size >= window()) return;
    sizes_.push_back(size);
    on_their_way_ += size;
    put(std::move(line));
    furthest_ = std::max(furthest_, ++next_);
  }
  if (answered_ < next_) return;
  if (next_ < job_.size()) return enter(State::kBeginning);
  enter(State::kWaiting);
}

/// Sends again from `line` on. Lines that have not been written yet are dropped.
void Sender::go_back(std::size_t line) {
  while (lines_out_.size() > (line_out_written_ > 0 ? 1U : 0U)) lines_out_.pop_back();
  resent_ += next_ - line;
  for (; next_ > line; --next_) {
    on_their_way_ -= sizes_.back();
    sizes_.pop_back();
  }
  moved_ = now_;
}

void Sender::put(std::string line) {
  if (on_line) on_line('>', line);
  lines_out_.push_back(std::move(line) + "\n");
}

/// Returns a realtime byte in the form in which it is sent between lines. With checked lines a
/// single byte may be a damaged one, so the byte is sent twice. A line end precedes the pair,
/// because the last line may have lost its own end, and no byte acts within a line. A question does
/// no harm, so it is sent as a single byte.
std::string Sender::between_lines(char byte) const {
  if (!numbers_lines_ || byte == '?') return {byte};
  return {'\n', byte, byte};
}

/// Realtime bytes are returned only between two lines, so that they spoil no line.
std::string_view Sender::output() {
  if (line_out_written_ == 0) {
    for (const char byte : realtime_) realtime_out_ += between_lines(byte);
    realtime_.clear();
    if (!realtime_out_.empty()) return realtime_out_;
  }
  if (lines_out_.empty()) return {};
  return std::string_view{lines_out_.front()}.substr(line_out_written_);
}

void Sender::wrote(std::size_t count) {
  if (!realtime_out_.empty() && line_out_written_ == 0) {
    realtime_out_.erase(0, count);
    return;
  }
  line_out_written_ += count;
  if (lines_out_.empty() || line_out_written_ < lines_out_.front().size()) return;
  lines_out_.pop_front();
  line_out_written_ = 0;
}

}  // namespace sim
