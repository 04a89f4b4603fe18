#!/usr/bin/env bash
# Installs what is missing, builds the gallery and renders it to build/gallery/index.html.
#   examples/run.sh [MODEL] [OPTIONS]      --help lists the options
# LVSM_BUILD_DIR (build) says where to build, LVSM_JOBS (the number of cores) how much at once.
set -euo pipefail
caller=$PWD
cd "$(dirname "$0")/.."
build=${LVSM_BUILD_DIR:-build}
jobs=${LVSM_JOBS:-$(nproc)}

tests/support/install_packages.sh
cmake -S . -B "$build" -G Ninja -DLVSM_BUILD_EXAMPLES=ON
cmake --build "$build" -j "$jobs" --target lvsm_gallery
gallery=$(realpath "$build")

# The model's path is meant from where the user stands.
cd "$caller"
exec "$gallery/examples/gallery/lvsm_gallery" --output "$gallery/gallery" "$@"
