#!/usr/bin/env bash
# Set-up, build, main job: streams the example programs through the simulated
# controller and leaves trace, picture and report of each in out/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

toolchain/setup.sh run
cmake --preset run
cmake --build --preset run

examples=host-sim/examples
settings=()
if [[ -f $examples/laser.settings ]]; then
  settings=(--settings "$examples/laser.settings")
fi

mkdir -p out
for program in "$examples"/*.nc; do
  name=out/$(basename "$program" .nc)
  build/run/host-sim/kerfline sim "$program" "${settings[@]}" \
    --trace "$name.trace.csv" --report "$name.report.json" --svg "$name.svg" --png "$name.png"
done

echo
echo "Written:"
for program in "$examples"/*.nc; do
  name=out/$(basename "$program" .nc)
  echo "  $name.png  $name.svg  $name.trace.csv  $name.report.json"
done
