#include "host-sim/serve/reception.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <string>
#include <utility>

namespace sim {
namespace {

using std::chrono::milliseconds;

/// Bytes and events at a sender's end of a connection.
struct Wire {
  std::string to_controller;
  std::string from_controller;
  bool open = true;
  bool ended = false;
  bool hung_up = false;
  std::function<void()> on_look{};  ///< Called once, when the server checks whether the connection
                                    ///< has ended.
};

class FakeConnection final : public Connection {
 public:
  explicit FakeConnection(Wire& wire) : wire_{wire} {}
  ~FakeConnection() override { wire_.hung_up = true; }
  std::size_t read(std::span<std::byte> into) override {
    const std::size_t count = std::min(into.size(), wire_.to_controller.size());
    for (std::size_t i = 0; i < count; ++i) into[i] = std::byte(wire_.to_controller[i]);
    wire_.to_controller.erase(0, count);
    return count;
  }
  std::size_t write(std::span<const std::byte> from) override {
    for (const std::byte byte : from) wire_.from_controller += static_cast<char>(byte);
    return from.size();
  }
  bool open() override {
    if (wire_.on_look) std::exchange(wire_.on_look, nullptr)();
    return wire_.open || !wire_.to_controller.empty();
  }
  void end() override { wire_.ended = true; }
  void add_to(std::vector<pollfd>&, Wishes) const override {}

 private:
  Wire& wire_;
};

class FakeTransport final : public Transport {
 public:
  explicit FakeTransport(std::deque<Wire*>& arriving) : arriving_{arriving} {}
  std::unique_ptr<Connection> accept() override {
    if (arriving_.empty()) return nullptr;
    Wire* wire = arriving_.front();
    arriving_.pop_front();
    return std::make_unique<FakeConnection>(*wire);
  }
  void add_to(std::vector<pollfd>&) const override {}
  std::string_view kind() const override { return "fake"; }
  std::string address() const override { return "nowhere"; }

 private:
  std::deque<Wire*>& arriving_;
};

class ReceptionTest : public testing::Test {
 protected:
  ReceptionTest() { reception.add(std::make_unique<FakeTransport>(arriving)); }

  void wait(int turns) {
    for (; turns > 0; --turns) {
      session.turn();
      now += milliseconds{1};
      reception.attend(now);
    }
  }

  Wire first;
  Wire second;
  std::deque<Wire*> arriving;
  hal::host::MemoryStore store;
  Session session{MachineModel{}, {}, store};
  Reception reception{session};
  Reception::Clock::time_point now{milliseconds{5000}};
};

TEST_F(ReceptionTest, GreetsASenderNotBeforeItsPortHasSettled) {
  arriving = {&first};
  first.to_controller = "G1 X2 F600\n?";
  wait(100);
  EXPECT_EQ(first.from_controller, "");
  EXPECT_EQ(first.to_controller.size(), 12U) << "waits for the greeting";
  wait(50);
  EXPECT_EQ(first.from_controller.substr(0, 9), "Grbl 1.1h");
  EXPECT_NE(first.from_controller.find("ok\r\n"), std::string::npos) << "and is not lost";
  EXPECT_EQ(reception.sender_kind(), "fake");
}

TEST_F(ReceptionTest, TellsASecondSenderWhyItIsHungUpOn) {
  arriving = {&first};
  wait(200);
  arriving = {&second};
  second.to_controller = "?";
  const std::string before = first.from_controller;
  wait(2);
  EXPECT_EQ(second.from_controller, Reception::kRefusal);
  EXPECT_TRUE(second.ended);
  EXPECT_FALSE(second.hung_up) << "it may read first";
  wait(600);
  EXPECT_TRUE(second.hung_up);
  EXPECT_EQ(second.from_controller, Reception::kRefusal);
  EXPECT_EQ(first.from_controller, before) << "the first is not disturbed";
}

TEST_F(ReceptionTest, LetsTheNextInWhenTheFirstHasGone) {
  arriving = {&first};
  wait(200);
  first.open = false;
  wait(1);
  EXPECT_TRUE(first.hung_up);
  EXPECT_EQ(reception.sender_kind(), "");
  arriving = {&second};
  wait(400);
  EXPECT_EQ(second.from_controller, "Grbl 1.1h ['$' for help]\r\n");
}

TEST_F(ReceptionTest, LetsOneInThatComesRightAfterTheFirstHasGone) {
  arriving = {&first};
  wait(200);
  first.to_controller = "?";
  first.open = false;
  arriving = {&second};
  wait(1);
  EXPECT_TRUE(first.hung_up);
  wait(400);
  EXPECT_EQ(second.from_controller, "Grbl 1.1h ['$' for help]\r\n");
}

/// The controller reads the first stream, which has already ended, and meanwhile the next sender
/// connects.
TEST_F(ReceptionTest, LetsOneInThatComesWhileTheLastIsBeingRead) {
  arriving = {&first};
  wait(200);
  first.open = false;
  first.on_look = [this] { arriving = {&second}; };
  wait(2);
  EXPECT_EQ(reception.sender_kind(), "fake");
  EXPECT_TRUE(first.hung_up);
  EXPECT_FALSE(second.hung_up);
  EXPECT_EQ(second.from_controller, "");
}

TEST_F(ReceptionTest, KeepsEveryLineOfASenderWhoSendsMoreThanThereIsRoomFor) {
  arriving = {&first};
  wait(200);
  first.from_controller.clear();
  const int lines = 3000;
  for (int line = 0; line < lines; ++line) first.to_controller += "G4 P0.001\n";
  wait(20);
  EXPECT_TRUE(first.to_controller.empty()) << "all is read, and waits here";
  wait(20'000);
  std::size_t answers = 0;
  for (std::size_t at = first.from_controller.find("ok\r\n"); at != std::string::npos;
       at = first.from_controller.find("ok\r\n", at + 1)) {
    ++answers;
  }
  EXPECT_EQ(answers, 3000U);
}

TEST_F(ReceptionTest, SaysNothingThatASenderCouldTakeForAnAnswer) {
  std::string words{Reception::kRefusal};
  std::transform(words.begin(), words.end(), words.begin(), ::tolower);
  EXPECT_EQ(words.find("ok"), std::string::npos);
  EXPECT_EQ(words.find("error"), std::string::npos);
}

}  // namespace
}  // namespace sim
