# Read by ctest of the sanitized build: tests of firmware that take 10 s and more there even with
# few trials. Only toolchain/prove.sh runs them under sanitizers, as it does all other test
# programs; toolchain/test.sh runs them in release.
set_tests_properties(MachineMotionTest.EndsEveryWayAtRest PROPERTIES LABELS prove)
