#include "host-sim/cut/order_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sim::cut {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

OrderFigures figures() {
  OrderFigures order;
  order.straight = {.length_mm = 300.0, .time_s = 60.0};
  order.rapids = order.straight;
  order.listed = {.length_mm = 310.0, .time_s = 64.0};
  order.file = {.length_mm = 900.0, .time_s = 120.0};
  order.nearest = {.length_mm = 400.0, .time_s = 80.0};
  return order;
}

TEST(OrderReport, ComparesOrdersByStraightWays) {
  OrderFigures order = figures();
  EXPECT_THAT(lines_of(order, 5), Not(Contains(HasSubstr("straight"))));
  order.rapids = {.length_mm = 350.0, .time_s = 70.0};  // The rapids lead around freed areas.
  const auto lines = lines_of(order, 5);
  EXPECT_THAT(lines[0], HasSubstr("350.0 mm and 70.0 s"));
  EXPECT_THAT(lines[1], HasSubstr("straight rapids: 300.0 mm and 60.0 s"));
  EXPECT_THAT(lines[2], HasSubstr("64.0 s of rapids; 6.2 percent saved"));
  EXPECT_THAT(lines[3], HasSubstr("50.0 percent saved"));
  EXPECT_THAT(lines[4], HasSubstr("25.0 percent saved"));
}

}  // namespace
}  // namespace sim::cut
