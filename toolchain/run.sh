#!/usr/bin/env bash
# Set-up, build, main job: streams the example programs through the simulated
# controller and leaves trace, picture and report of each in out/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

toolchain/setup.sh run
cmake --preset run
cmake --build --preset run

examples=host-sim/examples
mkdir -p out
for program in "$examples"/*.nc; do
  name=out/$(basename "$program" .nc)
  settings=$examples/laser.settings
  if [[ $name == *pocket* ]]; then
    settings=$examples/mill.settings
  fi
  build/run/host-sim/kerfline sim "$program" --settings "$settings" \
    --trace "$name.trace.csv" --report "$name.report.json" --svg "$name.svg" --png "$name.png"
done

echo
echo "Written:"
for program in "$examples"/*.nc; do
  name=out/$(basename "$program" .nc)
  echo "  $name.png  $name.svg  $name.trace.csv  $name.report.json"
done
