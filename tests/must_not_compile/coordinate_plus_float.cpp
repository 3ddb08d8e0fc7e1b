// EXPECT: no match for 'operator\+'
#include "planner/base/coordinate.hpp"

auto sum_in_no_unit(cnc::Coordinate place) { return place + 0.5F; }
