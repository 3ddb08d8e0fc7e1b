#!/usr/bin/env bash
# Sets up, builds, and runs the tests that guard against a broken product; the options are those of
# toolchain/proof/run.py. The last line is `N passed, N failed`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

toolchain/setup.sh test
exec python3 -B toolchain/proof/run.py test "$@"
