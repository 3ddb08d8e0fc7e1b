#include "tests/hal/stm32f405/usb/usb_desk.hpp"
#include "tests/support/trials.hpp"

namespace hal::stm32f405 {
namespace {

class UsbRandom : public UsbTest {};
using Shake = UsbDesk::Shake;

/// One long conversation with a host that acts in random order.
class Talk {
 public:
  explicit Talk(std::uint64_t seed) : desk_{seed} {
    desk_.host.set_manner({.device_turns_percent = 20 + desk_.host.below(81),
                           .lost_answers_percent = desk_.host.below(25)});
  }

  void run() {
    begin();
    for (int step = 0; step < 400 && !testing::Test::HasFailure(); ++step) act();
    finish();
  }

 private:
  void begin() {
    // If the acknowledgement of the address is lost, host and device disagree until the next reset.
    bool ready = false;
    for (int tries = 0; tries < 20 && !ready; ++tries) ready = desk_.ready();
    ASSERT_TRUE(ready);
    // Data that was under way at the end of the session is lost, in both directions.
    sent_ = heard_ = said_ = fetched_ = {};
    offered_ = {};
  }

  void act() {
    switch (desk_.host.below(12)) {
      case 0:
      case 1:
      case 2:
        return send();
      case 3:
      case 4:
      case 5:
        return fetch();
      case 6:
      case 7:
        return read();
      case 8:
      case 9:
        return write();
      case 10:
        return desk_.serve();
      default:
        return ask();
    }
  }

  /// Offers a packet until its arrival is acknowledged, as a host controller does.
  void send() {
    if (offered_.empty()) {
      offered_ = pattern(1 + desk_.host.below(64), static_cast<unsigned>(sent_.size()));
    }
    if (desk_.host.send(bytes_in(offered_)) != Shake::kAck) return;
    sent_ += offered_;
    offered_ = {};
  }
  void fetch() {
    if (const auto packet = desk_.host.fetch()) fetched_ += text_of(*packet);
  }
  void read() {
    std::string text(1 + desk_.host.below(200), '\0');
    desk_.begin_turn();
    text.resize(desk_.line.read(std::as_writable_bytes(std::span{text})));
    heard_ += text;
    // Everything that was sent must arrive, including a packet whose acknowledgement was lost.
    const std::string all = sent_ + offered_;
    ASSERT_EQ(all.substr(0, heard_.size()), heard_);
  }
  void write() {
    const std::string text =
        pattern(1 + desk_.host.below(300), static_cast<unsigned>(said_.size()));
    said_ += text.substr(0, desk_.line.write(std::as_bytes(std::span{text})));
    ASSERT_EQ(said_.substr(0, fetched_.size()), fetched_);
  }
  void ask() {
    switch (desk_.host.below(8)) {
      case 0:
        ASSERT_TRUE(desk_.host.close());
        return begin_session();
      case 1:
        desk_.core.suspend();
        desk_.serve();
        desk_.core.resume();
        desk_.serve();
        return forget();
      case 2:
        return begin();
      case 3:
        ASSERT_FALSE(desk_.host.ask(request(0xC0, 1, 2, 3, 64)).has_value());
        return;
      case 4:
        ASSERT_TRUE(desk_.host.tell(request(0x21, 0x20, 0, 0, 7), UsbDesk::Bytes(7, 3)));
        return;
      default:
        ASSERT_EQ(desk_.host.device_descriptor, desk_.host.ask(request(0x80, 6, 0x100, 0, 18)));
    }
  }
  void begin_session() {
    ASSERT_TRUE(desk_.host.open());
    desk_.serve();
    forget();
  }
  /// Clears the records and data toggles: the next packets belong to the new session.
  void forget() {
    sent_ = heard_ = said_ = fetched_ = {};
    offered_ = {};
    ASSERT_TRUE(desk_.host.tell(request(0x02, 1, 0, 0x01, 0)));
    ASSERT_TRUE(desk_.host.tell(request(0x02, 1, 0, 0x81, 0)));
    desk_.host.forget_data_toggles();
    desk_.serve();
  }

  void finish() {
    desk_.host.set_manner({});
    for (int turn = 0; turn < 400; ++turn) {
      fetch();
      read();
      desk_.serve();
      if (!offered_.empty()) send();
    }
    EXPECT_EQ(sent_, heard_);
    EXPECT_EQ(said_, fetched_);
    EXPECT_TRUE(desk_.core.misuse.empty()) << desk_.core.misuse.front();
  }

  UsbDesk desk_;
  std::string sent_, heard_, said_, fetched_;
  std::string offered_;
};

TEST_F(UsbRandom, NoByteIsLostOrDoubledWhateverTheHostDoes) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    SCOPED_TRACE("KERFLINE_SEED=" + std::to_string(seed));
    Talk{seed}.run();
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace hal::stm32f405
