#!/usr/bin/env bash
# Sets up and builds the project, and streams the example programs through the simulated controller.
# Writes a picture and a report of each to out/; with --traces also a trace of every step.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

examples=host-sim/examples
kerfline=build/run/host-sim/kerfline

usage() {
  cat <<TEXT
usage: toolchain/run.sh [--traces] [EXAMPLE...]
  --traces  also write each step as text, out/EXAMPLE.trace.csv: some 480 MB for all examples
  EXAMPLE   one of: $(names_of_examples); without any all of them
TEXT
}

names_of_examples() { basename -s .nc "$examples"/*.nc | paste -sd ' '; }

# refuse WHAT REMEDY
refuse() {
  echo "run.sh: $1" >&2
  echo "  $2" >&2
  exit 2
}

# name_of ARGUMENT: prints the name of the example; ARGUMENT may contain folder and ending.
name_of() {
  local name
  name=$(basename "$1" .nc)
  if [[ -f $examples/$name.nc ]]; then
    echo "$name"
  elif [[ -f $1 ]]; then
    refuse "$1 is not one of the examples" "a program of your own: $kerfline sim '$1' --svg out.svg"
  else
    refuse "there is no example $1" "the examples are: $(names_of_examples)"
  fi
}

# simulate EXAMPLE
simulate() {
  local settings=$examples/laser.settings outputs=()
  [[ $1 == *pocket* ]] && settings=$examples/mill.settings
  [[ -n $traces ]] && outputs=(--trace "out/$1.trace.csv")
  "$kerfline" sim "$examples/$1.nc" --settings "$settings" --progress \
    --report "out/$1.report.json" --svg "out/$1.svg" --png "out/$1.png" "${outputs[@]}"
}

traces=
names=()
for argument; do
  case $argument in
    --traces) traces=yes ;;
    -h | --help) usage; exit 0 ;;
    -*) refuse "unknown option $argument" "$(usage)" ;;
    *) names+=("$(name_of "$argument")") ;;
  esac
done
((${#names[@]})) || read -ra names <<<"$(names_of_examples)"

toolchain/setup.sh run
cmake --preset run
cmake --build --preset run

mkdir -p out
for index in "${!names[@]}"; do
  printf '\n[%d/%d] %s\n' $((index + 1)) ${#names[@]} "${names[index]}"
  begin=$SECONDS
  simulate "${names[index]}"
  echo "${names[index]}: done after $((SECONDS - begin)) s"
done

first=${names[0]}
endings=".png, .svg${traces:+, .trace.csv} and .report.json"
cat <<TEXT

Written to out/: $endings of ${names[*]}

Open      out/$first.png             the path as the step pulses drew it, coloured by speed
          out/$first.report.json     time, speeds, accelerations, distance from the program
Try next  $kerfline serve --ws 8080  and the page at http://127.0.0.1:8080/
          $kerfline sim YOURS.nc --svg yours.svg --report yours.json
          $kerfline cut $examples/plate.svg --material 'CSP 1N' --thickness 2 -o plate.nc
          cmake --install build/run --prefix ~/.local   for kerfline, its manual, completion
TEXT
[[ -n $traces ]] || echo "          toolchain/run.sh --traces $first   for each step of it as text"
