#!/usr/bin/env bash
# Builds all fuzz targets (tests/fuzz/fuzz_*.cc) with AddressSanitizer and UndefinedBehaviorSanitizer
# and runs each for a while from the seeds of tests/fuzz/seed_*.cc:
#
#   scripts/fuzz.sh [SECONDS [TARGET...]]     60 seconds each, unless told
#
# As many targets side by side as there are cores (RADIVE_FUZZ_JOBS); RADIVE_FUZZ_SEED other than 0
# makes runs from the same corpora alike. Prints a line a target at the
# end: executions, coverage (edges and features) and files in its corpus. A crash ends with status 1;
# its input is in build-fuzz/crashes/. Corpora stay in build-fuzz/corpus/ for the next time. Installs
# clang where it is missing; ends with status 77 where that cannot be done.
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${1:-60}
shift $(($# > 0 ? 1 : 0))
targets=("$@")
build=${RADIVE_FUZZ_BUILD_DIR:-build-fuzz}
jobs=${RADIVE_FUZZ_JOBS:-$(nproc)}
random_seed=${RADIVE_FUZZ_SEED:-0}

install_clang() {
  local sudo=()
  if [[ $(id -u) -ne 0 ]]; then sudo=(sudo); fi
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends clang libclang-rt-dev >/dev/null 2>&1
}

scripts/setup.sh
if ! command -v clang++ >/dev/null && ! install_clang; then
  echo "fuzz.sh: clang is missing and cannot be installed" >&2
  exit 77
fi

launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
cmake -S . -B "$build" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=None "${launcher[@]}" \
  -DRADIVE_BUILD_FUZZERS=ON -DRADIVE_BUILD_TESTS=OFF -DRADIVE_BUILD_APPS=OFF >/dev/null
cmake --build "$build" --parallel "$jobs" --target fuzzers >"$build/build.log" 2>&1 ||
  { cat "$build/build.log"; exit 1; }

programs=$build/tests/fuzz
mkdir -p "$build/seeds" "$build/corpus" "$build/crashes"
for seed in "$programs"/seed_*; do
  if [[ -f $seed && -x $seed ]]; then "$seed" "$build/seeds"; fi
done
if [[ ${#targets[@]} -eq 0 ]]; then
  for source in tests/fuzz/fuzz_*.cc; do targets+=("$(basename "$source" .cc)"); done
fi

# Runs one target; its line for the end goes to TARGET.result, which is empty after a failure.
fuzz() {
  local target=$1 log=$build/$1.log
  mkdir -p "$build/corpus/$target" "$build/seeds/$target"
  : >"$build/$target.result"
  # An input of a fuzzer is small: one that takes long or much memory is a finding too.
  "$programs/$target" -max_total_time="$seconds" -seed="$random_seed" -timeout=20 -rss_limit_mb=1500 \
    -malloc_limit_mb=300 -print_final_stats=1 \
    -artifact_prefix="$build/crashes/$target-" \
    "$build/corpus/$target" "$build/seeds/$target" >"$log" 2>&1 || return 0
  local executions coverage
  executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  coverage=$(grep -o 'cov: [0-9]* ft: [0-9]*' "$log" | tail -1)
  printf '%-22s %9d executions, %s, corpus %d files\n' "$target" "$executions" \
    "${coverage:-no coverage}" "$(find "$build/corpus/$target" -type f | wc -l)" \
    >"$build/$target.result"
}

for target in "${targets[@]}"; do
  while [[ $(jobs -rp | wc -l) -ge $jobs ]]; do wait -n; done
  fuzz "$target" &
done
wait

status=0
for target in "${targets[@]}"; do
  if [[ -s $build/$target.result ]]; then
    cat "$build/$target.result"
  else
    status=1
    echo "$target: FAILED, see $build/$target.log" >&2
    grep -E 'ERROR|SUMMARY|runtime error|Test unit written' "$build/$target.log" >&2 ||
      tail -5 "$build/$target.log" >&2
  fi
done
exit "$status"
