// EXPECT: ignoring return(ed)? value
#include "planner/base/result.hpp"

enum class Refusal { kNone };

cnc::Result<int, Refusal> make();

void drops_the_reason() { make(); }
