#!/usr/bin/env bash
# Builds all fuzz targets (tests/fuzz/fuzz_*.cc) with AddressSanitizer and UndefinedBehaviorSanitizer
# and runs each for a while from the seeds of tests/fuzz/seed_*.cc:
#
#   scripts/fuzz.sh [SECONDS [TARGET...]]     60 seconds each, unless told
#
# Prints the executions and the coverage of each. A crash ends with status 1; its input is in
# build-fuzz/crashes/. Corpora stay in build-fuzz/corpus/ for the next time. Installs clang where it
# is missing.
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${1:-60}
shift $(($# > 0 ? 1 : 0))
targets=("$@")
build=${RADIVE_FUZZ_BUILD_DIR:-build-fuzz}

scripts/setup.sh
if ! command -v clang++ >/dev/null; then
  sudo=()
  if [[ $(id -u) -ne 0 ]]; then sudo=(sudo); fi
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends clang libclang-rt-dev >/dev/null
fi

launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
cmake -S . -B "$build" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=None "${launcher[@]}" \
  -DRADIVE_BUILD_FUZZERS=ON -DRADIVE_BUILD_TESTS=OFF -DRADIVE_BUILD_APPS=OFF >/dev/null
cmake --build "$build" --parallel "$(nproc)" --target fuzzers >"$build/build.log" 2>&1 ||
  { cat "$build/build.log"; exit 1; }

programs=$build/tests/fuzz
mkdir -p "$build/seeds" "$build/corpus" "$build/crashes"
for seed in "$programs"/seed_*; do
  if [[ -f $seed && -x $seed ]]; then "$seed" "$build/seeds"; fi
done
if [[ ${#targets[@]} -eq 0 ]]; then
  for source in tests/fuzz/fuzz_*.cc; do targets+=("$(basename "$source" .cc)"); done
fi

status=0
for target in "${targets[@]}"; do
  mkdir -p "$build/corpus/$target" "$build/seeds/$target"
  log=$build/$target.log
  # An input of a fuzzer is small: one that takes long or much memory is a finding too.
  if "$programs/$target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=1500 \
    -malloc_limit_mb=300 -print_final_stats=1 \
    -artifact_prefix="$build/crashes/$target-" \
    "$build/corpus/$target" "$build/seeds/$target" >"$log" 2>&1; then
    executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    coverage=$(grep -o 'cov: [0-9]* ft: [0-9]*' "$log" | tail -1)
    echo "$target: $executions executions, ${coverage:-no coverage}"
  else
    status=1
    echo "$target: FAILED, see $log" >&2
    grep -E 'ERROR|SUMMARY|runtime error|Test unit written' "$log" >&2 || tail -5 "$log" >&2
  fi
done
exit "$status"
