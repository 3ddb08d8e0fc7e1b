#include "planner/geometry/arc_formulas.hpp"

namespace cnc {

template class BasicArc<double>;

}  // namespace cnc
