#!/usr/bin/env bash
# Set-up, builds, all tests. The last line is `N passed, N failed`; a build that
# fails counts as one failed test, and what does not need it goes on.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1

passed=0
failed=0
failures=()  # What failed, by name; told once more at the end.

step() { printf '\n==== %s (%s s)\n' "$*" "$SECONDS"; }

fail() {
  echo "FAILED: $1" >&2
  failures+=("$1")
  failed=$((failed + 1))
}

# build PRESET [TARGET]
build() {
  step "build $1"
  cmake --preset "$1" >/dev/null &&
    cmake --build --preset "$1" ${2:+--target "$2"} -- -k 0 && return
  fail "build of $1"
  return 1
}

# test_preset PRESET: runs ctest and adds its numbers up.
test_preset() {
  step "test $1"
  local log=build/$1/ctest.log summary skipped
  ctest --preset "$1" -j"$(nproc)" --output-on-failure 2>&1 | tee "$log"
  summary=$(grep -E '^[0-9]+% tests passed, [0-9]+ tests failed out of [0-9]+' "$log" | tail -1)
  if [[ $summary =~ ,\ ([0-9]+)\ tests\ failed\ out\ of\ ([0-9]+) ]]; then
    failed=$((failed + BASH_REMATCH[1]))
    skipped=$(grep -c '(Skipped)$' "$log")  # ctest counts them as passed.
    passed=$((passed + BASH_REMATCH[2] - BASH_REMATCH[1] - skipped))
    mapfile -t -O "${#failures[@]}" failures < <(names_of_failed "$1")
  else
    fail "ctest of $1 gave no result"
  fi
}

# names_of_failed PRESET: as ctest lists them under its summary.
names_of_failed() {
  sed -n "/^The following tests FAILED:/,/^Errors/s/^[[:space:]]*[0-9]* - \(.*\)/$1: \1/p" \
    "build/$1/ctest.log"
}

# again PRESET: what failed once more and alone, so that the end of the log tells why and whether
# it is a matter of load. It changes no verdict.
again() {
  [[ " ${failures[*]-} " == *" $1: "* ]] || return 0
  step "once more: what failed of $1"
  ctest --preset "$1" --rerun-failed --output-on-failure 2>&1 | tail -60
}

# Every fuzz program for a short while, from the seeds beside it and the examples.
fuzz() {
  compgen -G 'tests/fuzz/*.cpp' >/dev/null || return 0
  build fuzz fuzzers || return 0
  local program name seeds=(host-sim/examples)
  [[ -d tests/fuzz/seeds ]] && seeds+=(tests/fuzz/seeds)
  for program in build/fuzz/tests/fuzz_*; do
    [[ -x $program && -f $program ]] || continue
    name=$(basename "$program")
    step "$name"
    mkdir -p "build/fuzz/$name.corpus"
    if "$program" -max_total_time="${FUZZ_SECONDS:-30}" -timeout=10 -print_final_stats=1 \
      -artifact_prefix="build/fuzz/$name." "build/fuzz/$name.corpus" "${seeds[@]}" 2>&1 |
      tail -15; then
      passed=$((passed + 1))
    else
      fail "$name"
    fi
  done
}

# Figures of this machine and instruction counts; printed, not judged.
benchmarks() {
  step "benchmarks"
  build/release/tests/bench_stages --benchmark_min_time=0.05 2>/dev/null
  build/release/tests/bench_job_times
  tests/bench/count_instructions.py build/release/host-sim/kerfline || fail "instruction counts"
}

# The senders that the lock file pins, away from the sources.
install_senders() {
  step "senders"
  mkdir -p build/senders
  cp tests/senders/package.json tests/senders/package-lock.json build/senders/
  npm ci --prefix build/senders --no-audit --no-fund --loglevel=error && return
  fail "npm ci of tests/senders"
}

# What one build has compiled no other one compiles again, not even that of a clone somewhere
# else, as a test of the README makes one.
remember_compilations() {
  export PATH=/usr/lib/ccache:$PATH
  export CCACHE_DIR=$PWD/build/ccache CCACHE_BASEDIR=/ CCACHE_NOHASHDIR=1
}

toolchain/setup.sh test || exit 1
install_senders
remember_compilations
export UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=detect_stack_use_after_return=1

build cortex-m4f  # Before the release tests, which look into it.
build release && test_preset release && benchmarks
# Sanitizers cost ten times the time: no more random trials than so many, and fewer than usual.
export KERFLINE_MOST_TRIALS="${KERFLINE_MOST_TRIALS:-60}"
build sanitize && test_preset sanitize
fuzz

again release
again sanitize

step finished
for name in ${failures[@]+"${failures[@]}"}; do echo "failed: $name"; done
echo "$passed passed, $failed failed"
((failed == 0))
