#!/usr/bin/env bash
# Sets up, builds, and runs everything that this project can prove; run again, it goes on where it
# was interrupted. The options are those of toolchain/proof/run.py.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

toolchain/setup.sh prove
exec python3 -B toolchain/proof/run.py prove "$@"
