#!/usr/bin/env bash
# Installs what is missing and writes the viewer to build/viewer/index.html, one file that opens from disk.
#   examples/viewer/build.sh
# LVSM_BUILD_DIR (build) says where to build. Status 77 says that npm, or what else it needs, is missing.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${LVSM_BUILD_DIR:-build}

tests/support/install_packages.sh
cmake -S . -B "$build" -G Ninja >/dev/null
build=$(realpath "$build")
cmake --build "$build" --target lvsm_single
cmake --build "$build" --target lvsm_wasm || { echo "skipped: no C++ for WebAssembly here"; exit 77; }
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:[^=]*=//p' "$build/CMakeCache.txt")

# The packages are those of the browser tests.
mkdir -p "$build/tests/clients"
cd "$build/tests/clients"
exec "$OLDPWD/tests/clients/run" ../../examples/viewer/build.mjs "$build/single" "$build/wasm" "$version" "$build/viewer"
