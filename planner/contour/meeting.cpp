#include "planner/contour/meeting_formulas.hpp"

namespace cnc::contour {

template Meetings<float> meetings_of(const Curve<float>&, const Curve<float>&, float);

}  // namespace cnc::contour
