#include "planner/contour/meeting_formulas.hpp"

namespace cnc::contour {

template Meetings<double> meetings_of(const Curve<double>&, const Curve<double>&, double);

}  // namespace cnc::contour
