#!/usr/bin/env bash
# Installs what is missing, builds, and runs all tests.
set -euo pipefail
cd "$(dirname "$0")/.."

set -x
scripts/setup.sh
scripts/build.sh -DRADIVE_BUILD_TESTS=ON -DRADIVE_BUILD_APPS=ON -DRADIVE_WERROR=ON
ctest --test-dir "${RADIVE_BUILD_DIR:-build}" --output-on-failure --parallel "$(nproc)"
