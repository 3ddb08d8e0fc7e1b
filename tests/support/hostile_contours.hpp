#pragma once

#include "tests/support/contour_corpus.hpp"

namespace proof {

/// Right angles on a grid of whole millimetres with fillets of 0, ½ or 1 mm,
/// offset by whole, half and quarter millimetres: fillets and slots that are
/// just used up, edges that vanish, corners that meet.
[[nodiscard]] OffsetCase random_mech(Random& random);

/// A plate with holes, some of which hold an island with a hole of its own.
[[nodiscard]] OffsetCase random_islands(Random& random);

/// Double points, zero-length edges, spikes with and without width, arcs that
/// join within a millionth of their tangents, deep slots, circles inside each
/// other, and distances that just use up what is there.
[[nodiscard]] OffsetCase random_hostile(Random& random);

}  // namespace proof
