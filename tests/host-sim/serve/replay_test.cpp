#include "host-sim/serve/replay.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string_view>

#include "firmware/protocol/identity.hpp"
#include "host-sim/serve/recorder.hpp"
#include "host-sim/serve/session.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

/// A recorded session with a sender that may be slow to read.
class RecordedSession {
 public:
  RecordedSession() {
    said_.setting.probe_plate_z_mm = MachineModel{}.probe_plate_z_mm;
    session_.link().tell(&recorder_);
    session_.link().connect();
  }

  void send(std::string_view text) {
    session_.link().receive(std::as_bytes(std::span{text.substr(0, session_.link().room())}));
  }
  void turn(unsigned times = 1) {
    for (; times > 0; --times) session_.turn();
  }
  void listen() {
    while (!session_.link().outgoing().empty()) {
      session_.link().taken(session_.link().outgoing().size());
    }
  }
  Session& session() { return session_; }

  Conversation end() {
    recorder_.finish();
    said_.end_ns = session_.controller().now_ticks() * VirtualController::kNanosecondsPerTick;
    return parse_conversation(to_text(said_), "recorded");
  }

 private:
  hal::host::MemoryStore store_;
  Session session_{MachineModel{}, {}, store_};
  Conversation said_{};
  Recorder recorder_{session_.controller(),
                     [this](const Exchange& exchange) { said_.exchanges.push_back(exchange); }};
};

std::string all_said(const Conversation& conversation) {
  std::string text;
  for (const Exchange& exchange : conversation.exchanges) {
    if (exchange.kind == Exchange::Kind::kSaid) text += exchange.bytes;
  }
  return text;
}

TEST(Replay, SaysTheSameAtTheSameTimes) {
  for (const std::uint64_t seed : proof::Trials{5}) {
    std::mt19937 random{seed};
    RecordedSession talk;
    for (int round = 0; round < 300; ++round) {
      switch (random() % 6) {
        case 0:
          talk.send("?");
          break;
        case 1:
          talk.send("G1 X" + std::to_string(random() % 50) + " F3000\n");
          break;
        case 2:
          talk.send("$G\nnonsense\n");
          break;
        case 3:
          talk.send(random() % 2 == 0 ? "!" : "~");
          break;
        default:
          break;
      }
      talk.turn(static_cast<unsigned>(random() % 20));
      talk.listen();
    }
    const Conversation recorded = talk.end();
    ASSERT_GT(all_said(recorded).size(), 1000U);
    const Conversation again = replay(recorded);
    EXPECT_EQ(first_difference(recorded, again, true), std::nullopt) << "KERFLINE_SEED=" << seed;
    EXPECT_EQ(to_text(again), to_text(recorded)) << "KERFLINE_SEED=" << seed;
  }
}

/// The stop came over a bus, separately from all other bytes, in the middle of a motion.
TEST(Replay, StopsWhereTheMachineWasStopped) {
  RecordedSession talk;
  talk.send("G91 G1 X100 F600\n");
  talk.turn(300);
  talk.session().emergency_stop();
  talk.turn(50);
  talk.send("?");
  talk.turn(5);
  const Conversation recorded = talk.end();
  ASSERT_NE(all_said(recorded).find("ALARM:24"), std::string::npos);
  EXPECT_EQ(to_text(replay(recorded)), to_text(recorded));
}

TEST(Replay, IsJustAsSlowToReadAsTheSenderWas) {
  RecordedSession talk;
  for (int round = 0; round < 400; ++round) {
    talk.send("$$\n$$\n$$\n?");
    talk.turn();
  }
  talk.listen();
  talk.turn(100);
  const Conversation recorded = talk.end();
  bool was_full = false;
  for (const Exchange& exchange : recorded.exchanges) {
    was_full = was_full || exchange.kind == Exchange::Kind::kFull;
  }
  ASSERT_TRUE(was_full);
  EXPECT_EQ(to_text(replay(recorded)), to_text(recorded));
}

TEST(Replay, FindsTheFirstDifference) {
  RecordedSession talk;
  talk.send("$G\nG0 X1\n");
  talk.turn(500);
  Conversation recorded = talk.end();
  for (Exchange& exchange : recorded.exchanges) {
    const std::size_t place = exchange.bytes.find("G54");
    if (exchange.kind != Exchange::Kind::kSaid || place == std::string::npos) continue;
    exchange.bytes[place + 2] = '5';
    const auto difference = first_difference(recorded, replay(recorded), false);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->line, exchange.line);
    EXPECT_NE(difference->expected.find("G55"), std::string::npos);
    EXPECT_NE(difference->said.find("G54"), std::string::npos);
    return;
  }
  FAIL() << "the controller never said G54";
}

TEST(Replay, ComparesAcrossVersions) {
  RecordedSession talk;
  talk.send("$I+\n");
  talk.turn(500);
  Conversation recorded = talk.end();
  const std::string now{cnc::identity::version()};
  for (Exchange& exchange : recorded.exchanges) {
    const std::size_t place = exchange.bytes.find(now);
    if (place == std::string::npos) continue;
    exchange.bytes.replace(place, now.size(), "0.1");
    const Conversation said = replay(recorded);
    EXPECT_NE(all_said(recorded), all_said(said));
    EXPECT_EQ(first_difference(recorded, said, true), std::nullopt);
    exchange.bytes.replace(exchange.bytes.find("FIRMWARE"), 3, "SOF");
    EXPECT_NE(first_difference(recorded, said, false), std::nullopt);
    return;
  }
  FAIL() << "the controller never said its version";
}

TEST(Replay, NoticesThatSomethingIsMissingAtTheEnd) {
  RecordedSession talk;
  talk.send("?");
  talk.turn(5);
  Conversation recorded = talk.end();
  recorded.exchanges.push_back({Exchange::Kind::kSaid, recorded.end_ns, "ok\r\n", 99});
  const auto difference = first_difference(recorded, replay(recorded), false);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->line, 99U);
  EXPECT_EQ(difference->expected, "ok");
  EXPECT_EQ(difference->said, "");
}

TEST(Replay, ComparesTimesOnlyWhenAsked) {
  RecordedSession talk;
  talk.send("$G\n");
  talk.turn(5);
  const Conversation recorded = talk.end();
  Conversation later = recorded;
  for (Exchange& exchange : later.exchanges) exchange.time_ns += 1'000'000;
  EXPECT_EQ(first_difference(recorded, later, false), std::nullopt);
  EXPECT_NE(first_difference(recorded, later, true), std::nullopt);
}

}  // namespace
}  // namespace sim
