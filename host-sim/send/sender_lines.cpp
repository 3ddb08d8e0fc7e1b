#include <fmt/format.h>

#include <algorithm>

#include "firmware/link/receiver.hpp"
#include "host-sim/send/sender.hpp"

namespace sim {
namespace {

constexpr std::size_t kGrblRoom = 128;
/// Bytes in flight with checked lines. At 115,200 baud they take 22 ms, which is longer than the
/// time by which adapters delay answers.
constexpr std::size_t kCheckedWindow = 256;

}  // namespace

void Sender::ask() {
  ++questions_;
  asked_ = now_;
  answers_owed_ += 2;
  put("");  // An empty line ends a line that another sender has begun.
  put("$I");
}

void Sender::begin() {
  ++questions_;
  asked_ = now_;
  // Only Kerfline has checked lines, so its buffer size is known. The announced size is not used,
  // because it may be damaged.
  room_ = cnc::Receiver::kAdvertisedBytes;
  numbering_.begun = answered();
  const std::uint32_t n = answered() < job_.size() ? job_[answered()].n : 1U;
  numbering_.first = n <= options_.max_number ? std::max(1U, n) : 1U;
  put(with_crc(fmt::format("N{}M110", numbering_.first - 1)));
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
  if (numbering_.active) return with_crc(fmt::format("N{}{}", number_of(line), text));
  return n == 0 || text.starts_with('$') ? text : fmt::format("N{}{}", n, text);
}

std::uint32_t Sender::number_of(std::size_t line) const {
  return numbering_.first + static_cast<std::uint32_t>(line - numbering_.begun);
}

void Sender::send_lines() {
  if (state_ != State::kSending) return;
  while (lines_.next() < job_.size()) {
    if (numbering_.active && number_of(lines_.next()) > options_.max_number) break;
    const std::string line = text_of(lines_.next());
    // A line that is longer than the window is sent alone.
    const std::size_t size = line.size() + 1;
    if (lines_.count() > 0 && lines_.bytes() + size >= window()) return;
    lines_.send(size);
    put(line);
  }
  if (lines_.count() > 0) return;
  if (lines_.next() < job_.size()) return enter(State::kBeginning);
  enter(State::kWaiting);
}

/// Sends the lines from `line` on again. Drops lines that have not been written yet.
void Sender::go_back(std::size_t line) {
  out_.drop_lines();
  lines_.go_back(line);
  moved_ = now_;
}

void Sender::put(std::string_view line) {
  if (on_line) on_line('>', line);
  out_.put_line(line);
}

}  // namespace sim
