#!/usr/bin/env bash
# Installs what is missing, configures, builds and runs every test, and ends with "N passed, N failed, N skipped".
#   tests/run.sh [CTEST OPTIONS]      for example  tests/run.sh -R parity
# With CI=true a missing device or compiler is a failure and warnings are errors. LVSM_BUILD_DIR (build) says where
# to build, LVSM_JOBS (the number of cores) how much at once.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${LVSM_BUILD_DIR:-build}
jobs=${LVSM_JOBS:-$(nproc)}
strict=OFF
[ "${CI:-}" != true ] || strict=ON

# Until the tests have run to their end, the honest summary is one failure.
summary="0 passed, 1 failed, 0 skipped"
trap 'echo "$summary"' EXIT

tests/support/install_packages.sh
cmake -S . -B "$build" -G Ninja -DLVSM_BUILD_TESTS=ON -DLVSM_BUILD_EXAMPLES=ON \
    -DLVSM_REQUIRE_DEVICE=$strict -DLVSM_WARNINGS_AS_ERRORS=$strict
cmake --build "$build" -j "$jobs"

results=$(realpath "$build")/reports/ctest.xml
mkdir -p "$(dirname "$results")"
rm -f "$results"
status=0
ctest --test-dir "$build" -j "$jobs" --output-on-failure --no-tests=error --output-junit "$results" "$@" || status=$?
[ -s "$results" ] || exit 1
summary=$(python3 tests/support/summary.py "$results")
exit $status
