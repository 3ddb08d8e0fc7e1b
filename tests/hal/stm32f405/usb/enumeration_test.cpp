#include "tests/hal/stm32f405/usb/usb_desk.hpp"

namespace hal::stm32f405 {
namespace {

class UsbEnumeration : public UsbTest {};
using Request = UsbHost::Request;
using Bytes = UsbDesk::Bytes;

TEST_F(UsbEnumeration, GoesAsLinuxDoesIt) {
  UsbDesk desk;
  ASSERT_TRUE(desk.host.enumerate());
  EXPECT_EQ((Bytes{18, 1, 0, 2, 2, 0, 0, 64, 0x09, 0x12, 0x01, 0x00, 0, 1, 1, 2, 3, 1}),
            desk.host.device_descriptor);
  EXPECT_EQ(67U, desk.host.configuration_descriptor.size());
  EXPECT_EQ((Bytes{4, 3, 0x09, 0x04}), desk.host.strings[0]);
  EXPECT_EQ("Kerfline", letters_of(desk.host.strings[1]));
  EXPECT_EQ("Generic F405/F407", letters_of(desk.host.strings[2]));
  EXPECT_EQ("1234ABC01234ABC11234ABC2", letters_of(desk.host.strings[3]));
  EXPECT_EQ(0U, desk.line.session());
  ASSERT_TRUE(desk.host.open());
  EXPECT_NE(0U, desk.line.session());
}

TEST_F(UsbEnumeration, ThePinsAreTheCores) {
  const UsbDesk desk;
  for (const int pin : {11, 12}) {
    EXPECT_EQ(2U, desk.chip.mode_of(pa(pin)));
    EXPECT_EQ(10U, desk.chip.cells[gpio::alternate(0, 8)] >> (4 * (pin - 8)) & 0xFU);
  }
}

TEST_F(UsbEnumeration, RequestsGetWhatTheyAskForAndNoMore) {
  UsbDesk desk;
  ASSERT_TRUE(desk.ready());
  for (const unsigned length : {0U, 1U, 8U, 63U, 64U, 65U, 67U, 68U, 255U, 65'535U}) {
    const auto got = desk.host.ask(request(0x80, 6, 0x200, 0, length));
    ASSERT_TRUE(got.has_value()) << length;
    EXPECT_EQ(std::min(length, 67U), got->size());
    EXPECT_TRUE(std::equal(got->begin(), got->end(), desk.host.configuration_descriptor.begin()));
  }
  EXPECT_EQ((Bytes{1, 0}), desk.host.ask(request(0x80, 0, 0, 0, 2)));
  EXPECT_EQ((Bytes{0, 0}), desk.host.ask(request(0x81, 0, 0, 1, 2)));
  EXPECT_EQ((Bytes{1}), desk.host.ask(request(0x80, 8, 0, 0, 1)));
  EXPECT_EQ((Bytes{0}), desk.host.ask(request(0x81, 10, 0, 1, 1)));
  // The string has 17 letters, which makes 36 bytes. With 31 letters it would fill a packet.
  EXPECT_EQ(36U, desk.host.ask(request(0x80, 6, 0x302, 0x409, 255))->size());
}

TEST_F(UsbEnumeration, ALineCodingIsKept) {
  UsbDesk desk;
  ASSERT_TRUE(desk.ready());
  EXPECT_EQ((Bytes{0x80, 0x25, 0, 0, 0, 0, 8}), desk.host.ask(request(0xA1, 0x21, 0, 0, 7)));
  const Bytes fast{0x00, 0xC2, 0x01, 0, 2, 1, 7};
  ASSERT_TRUE(desk.host.tell(request(0x21, 0x20, 0, 0, 7), fast));
  EXPECT_EQ(fast, desk.host.ask(request(0xA1, 0x21, 0, 0, 7)));
}

TEST_F(UsbEnumeration, WhatIsMalformedIsStalledAndTheNextIsHeard) {
  UsbDesk desk;
  ASSERT_TRUE(desk.ready());
  const std::array<Request, 17> to_host{
      request(0x80, 6, 0x600, 0, 10),  // A device qualifier, which only high-speed devices have.
      request(0x80, 6, 0x101, 0, 18),  // A second device.
      request(0x80, 6, 0x201, 0, 9),   // A second configuration.
      request(0x80, 6, 0x304, 0x409, 255),  // A string that does not exist.
      request(0x80, 6, 0x3FF, 0x409, 255),
      request(0x80, 6, 0xF00, 0, 5),    // A BOS descriptor, which belongs to USB 2.1.
      request(0x81, 6, 0x2200, 0, 64),  // A report of a keyboard.
      request(0x82, 0, 0, 0x02, 2),     // Endpoints that do not exist.
      request(0x82, 0, 0, 0x83, 2),
      request(0x82, 0, 0, 0x1234, 2),
      request(0x81, 0, 0, 2, 2),  // An interface that does not exist.
      request(0x81, 10, 0, 7, 1),
      request(0xA1, 0x21, 0, 1, 7),   // The line coding of the data interface.
      request(0xA1, 0x01, 0, 0, 8),   // An encapsulated response.
      request(0xC0, 0x51, 0, 0, 16),  // A vendor's request.
      request(0xFF, 0xFF, 0xFFFF, 0xFFFF, 0xFFFF),
      request(0x80, 12, 0, 0, 2)};
  for (const Request& odd : to_host) {
    EXPECT_FALSE(desk.host.ask(odd).has_value());
    EXPECT_TRUE(desk.host.stalled());
    EXPECT_TRUE(desk.host.ask(request(0x80, 6, 0x100, 0, 18)).has_value());
  }
  const std::array<Request, 13> to_device{
      request(0x00, 5, 200, 0, 0),  // An address beyond 127, and an address while configured.
      request(0x00, 5, 9, 0, 0),
      request(0x00, 9, 2, 0, 0),  // A configuration that does not exist.
      request(0x00, 3, 1, 0, 0),  // Remote wake-up, and a test mode.
      request(0x00, 3, 2, 0x100, 0),
      request(0x02, 3, 0, 0x84, 0),  // Halts of endpoints that do not exist.
      request(0x02, 3, 1, 0x81, 0),
      request(0x01, 11, 1, 1, 0),    // Another alternate setting.
      request(0x21, 0x22, 3, 1, 0),  // Control lines of an interface that has none.
      request(0x21, 0x23, 100, 0, 0),
      request(0x21, 0x20, 0, 0, 0),  // A line coding without bytes, and one of the data interface.
      request(0x21, 0x20, 0, 1, 7),
      request(0x40, 1, 2, 3, 0)};
  for (const Request& odd : to_device) {
    EXPECT_FALSE(desk.host.tell(odd));
    EXPECT_TRUE(desk.host.stalled());
    EXPECT_TRUE(desk.host.ask(request(0x80, 6, 0x100, 0, 18)).has_value());
  }
  EXPECT_FALSE(desk.host.tell(request(0x21, 0x20, 0, 0, 500), Bytes(500, 1)));
  // Fewer bytes than announced.
  EXPECT_FALSE(desk.host.tell(request(0x21, 0x20, 0, 0, 7), Bytes(3, 1)));
  EXPECT_EQ((Bytes{0x80, 0x25, 0, 0, 0, 0, 8}), desk.host.ask(request(0xA1, 0x21, 0, 0, 7)));
  EXPECT_NE(0U, desk.line.session());
}

TEST_F(UsbEnumeration, NothingOfTheLineWithoutAConfiguration) {
  UsbDesk desk;
  desk.host.reset_bus();
  EXPECT_FALSE(desk.host.open());
  EXPECT_FALSE(desk.host.tell(request(0x21, 0x20, 0, 0, 7), Bytes(7, 1)));
  EXPECT_FALSE(desk.host.ask(request(0x82, 0, 0, 0x81, 2)).has_value());
  EXPECT_EQ(UsbDesk::Shake::kSilence, desk.host.send({1, 2, 3}));
  ASSERT_TRUE(desk.ready());
  ASSERT_TRUE(desk.host.tell(request(0x00, 9, 0, 0, 0)));
  EXPECT_EQ(0U, desk.line.session());
  EXPECT_EQ(UsbDesk::Shake::kSilence, desk.host.send({1, 2, 3}));
}

TEST_F(UsbEnumeration, SurvivesAResetAtAnyTransaction) {
  UsbDesk whole;
  ASSERT_TRUE(whole.ready());
  const long all = whole.host.transactions();
  ASSERT_GT(all, 40);
  for (long cut = 0; cut < all; ++cut) {
    UsbDesk desk;
    desk.host.cut_after(cut);
    EXPECT_FALSE(desk.ready());
    desk.host.cut_after(-1);
    ASSERT_TRUE(desk.ready()) << "cut after " << cut;
    EXPECT_EQ(whole.host.configuration_descriptor, desk.host.configuration_descriptor);
    ASSERT_TRUE(desk.host.send_all({'?'}));
    EXPECT_EQ("?", desk.hear());
    ASSERT_TRUE(desk.core.misuse.empty()) << desk.core.misuse.front();
  }
}

TEST_F(UsbEnumeration, ARequestMayEndTheOneBefore) {
  UsbDesk desk;
  ASSERT_TRUE(desk.ready());
  for (long transactions = 1; transactions < 4; ++transactions) {
    desk.host.cut_after(transactions);
    EXPECT_FALSE(desk.host.ask(request(0x80, 6, 0x200, 0, 255)).has_value());
    desk.host.cut_after(-1);
    EXPECT_EQ(desk.host.device_descriptor, desk.host.ask(request(0x80, 6, 0x100, 0, 18)));
    desk.host.cut_after(transactions);
    static_cast<void>(desk.host.tell(request(0x21, 0x20, 0, 0, 7), Bytes(7, 9)));
    desk.host.cut_after(-1);
    EXPECT_EQ(desk.host.device_descriptor, desk.host.ask(request(0x80, 6, 0x100, 0, 18)));
  }
}

TEST_F(UsbEnumeration, IsNotThereWithoutTheCrystalOrTheCore) {
  Clocks internal = kFullSpeed;
  internal.source = ClockSource::kInternal;
  for (const Clocks& clocks : {internal, Clocks{}}) {
    UsbDesk desk{1, clocks};
    EXPECT_FALSE(desk.core.attached());
    EXPECT_EQ(0U, desk.say("ok"));
    EXPECT_EQ("", desk.hear());
  }
  UsbBus::core() = {};
  UsbBus::core().answers = false;
  ChipModel& chip = ModelBus::start_anew();
  UsbRings rings;
  UsbDesk::Line line{rings};
  line.set_up(kFullSpeed);
  EXPECT_FALSE(UsbBus::core().attached());
  EXPECT_EQ(0U, chip.cells[core::interrupt_on(67)]);
  EXPECT_EQ(0U, line.session());
}

TEST_F(UsbEnumeration, WaitsUntilTheCoreIsADevice) {
  UsbBus::core() = {};
  UsbBus::core().looks_as_host = 1000;
  ModelBus::start_anew();
  UsbRings rings;
  UsbDesk::Line line{rings};
  line.set_up(kFullSpeed);
  EXPECT_TRUE(UsbBus::core().attached());
}

}  // namespace
}  // namespace hal::stm32f405
