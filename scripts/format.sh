#!/usr/bin/env bash
# Formats all C++ sources with clang-format; with --check only tells which are not formatted.
set -euo pipefail
cd "$(dirname "$0")/.."

mode=(-i)
if [[ ${1:-} == --check ]]; then mode=(--dry-run --Werror); fi
git ls-files -z '*.h' '*.cc' | xargs -0 clang-format "${mode[@]}"
