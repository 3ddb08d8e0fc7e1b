#include "host-sim/serve/reception.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace sim {
namespace {

constexpr std::size_t kPart = 1024;

}  // namespace

void Reception::attend(Clock::time_point now) {
  if (sender_) attend_sender(now);
  for (const auto& way : ways_in_) {
    if (way->take_stop()) session_.emergency_stop();
    while (auto connection = way->accept()) meet(std::move(connection), *way, now);
  }
  see_off(now);
}

void Reception::meet(std::unique_ptr<Connection> connection,
                     const Transport& way,
                     Clock::time_point now) {
  if (sender_) {
    departing_.push_back({std::move(connection), now + kFarewell, kRefusal});
    return;
  }
  sender_ = std::move(connection);
  sender_kind_ = way.kind();
  greet_at_ = now + kGreetAfter;
  greeted_ = false;
}

void Reception::see_off(Clock::time_point now) {
  std::array<std::byte, kPart> unheard{};
  for (Departing& one : departing_) {
    // Reading on keeps the kernel from throwing our words away with a reset.
    if (one.connection->read(unheard) == unheard.size()) continue;
    if (one.words.empty()) continue;
    one.words.remove_prefix(one.connection->write(std::as_bytes(std::span{one.words})));
    if (one.words.empty()) one.connection->end();
  }
  std::erase_if(departing_, [now](const Departing& one) {
    return now >= one.until || !one.connection->open();
  });
}

void Reception::attend_sender(Clock::time_point now) {
  if (!greeted_ && now >= greet_at_ && session_.calm()) {
    session_.welcome_sender();
    greeted_ = true;
  }
  if (greeted_ && session_.hears()) {
    for (std::byte byte{}; sender_->take_realtime(byte);) session_.act_at_once(byte);
    carry_in();
  }
  if (greeted_) carry_out();
  if (sender_->open()) return;
  sender_.reset();
  sender_kind_ = {};
  if (greeted_) session_.lose_sender();
}

void Reception::carry_in() {
  std::array<std::byte, kPart> bytes{};
  while (session_.link().room() > 0) {
    const std::size_t wanted = std::min(bytes.size(), session_.link().room());
    const std::size_t count = sender_->read(std::span{bytes}.first(wanted));
    session_.link().receive(std::span{bytes}.first(count));
    if (count < wanted) return;
  }
}

void Reception::carry_out() {
  LiveLink& link = session_.link();
  while (!link.outgoing().empty()) {
    const std::size_t count = sender_->write(link.outgoing());
    if (count == 0) return;
    link.taken(count);
  }
}

void Reception::add_to(std::vector<pollfd>& descriptors) {
  for (const auto& way : ways_in_) way->add_to(descriptors);
  for (const Departing& one : departing_) one.connection->add_to(descriptors, {.read = true});
  if (!sender_) return;
  const Wishes wishes{.read = greeted_ && session_.hears() && session_.link().room() > 0,
                      .write = greeted_ && !session_.link().outgoing().empty()};
  if (wishes.read || wishes.write) sender_->add_to(descriptors, wishes);
}

}  // namespace sim
