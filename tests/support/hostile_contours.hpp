#pragma once

#include "tests/support/contour_corpus.hpp"

namespace proof {

/// Returns a shape of right angles on a grid of whole millimetres with fillets of 0, ½ or 1 mm. Its
/// offset is of whole, half or quarter millimetres, so that fillets and slots are just used up,
/// edges vanish and corners coincide.
[[nodiscard]] OffsetCase random_mech(Random& random);

/// Returns a plate with holes, some of which contain an island that has a hole, too.
[[nodiscard]] OffsetCase random_islands(Random& random);

/// Returns a contour that is difficult to offset: double points, edges without length, spikes with
/// and without width, arcs that join within a millionth of their tangents, deep slots or nested
/// circles. Some distances just use up the shape.
[[nodiscard]] OffsetCase random_hostile(Random& random);

}  // namespace proof
