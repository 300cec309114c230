#!/usr/bin/env bash
# Configures and builds into build/ (or $RADIVE_BUILD_DIR), folder by folder (RADIVE_UNITY). Further arguments go
# to cmake's configure step.
set -euo pipefail
cd "$(dirname "$0")/.."

build=${RADIVE_BUILD_DIR:-build}
launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
set -x
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DRADIVE_UNITY=ON "${launcher[@]}" "$@"
cmake --build "$build" --parallel "$(nproc)"
