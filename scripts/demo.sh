#!/usr/bin/env bash
# From nothing to a report: installs what is missing, builds, simulates a street with a dense and a
# sparse radar, estimates the drives, prints their errors and writes report/report.html.
# Everything lands in demo/ (or in the folder given).
set -euo pipefail
cd "$(dirname "$0")/.."

out=${1:-demo}
frames=${RADIVE_DEMO_FRAMES:-300}
bin=${RADIVE_BUILD_DIR:-build}/apps

run() {
  echo "+ $*"
  "$@"
}

run scripts/setup.sh
echo "+ scripts/build.sh"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
configuration=(-DRADIVE_BUILD_APPS=ON)
# Compiling the tests takes longer than all else: not for a first look.
if [[ ! -f ${bin%/apps}/CMakeCache.txt ]]; then configuration+=(-DRADIVE_BUILD_TESTS=OFF); fi
scripts/build.sh "${configuration[@]}" >"$log" 2>&1 || {
  cat "$log" >&2
  exit 1
}

evaluate() {
  "$bin/radive_evaluate" --reference="$1/reference.tum" --estimate="$1/trajectory_tum.txt" \
    --align=se3 --plane=xy --json "${@:2}"
}
rmse() { sed -n 's/^ *"rmse": *\([0-9.e-]*\),*$/\1/p'; }

begin=$SECONDS
rm -rf "${out:?}"/{scans,runs,report}
runs=()
summary=()
# A scenario, and the settings of the real sensor that it imitates. The simulator writes raw
# x y z doppler power records.
for pair in street_dense:mscrad4r street_sparse:hercules_ars548; do
  scenario=${pair%%:*}
  config=configs/${pair##*:}.yaml
  results=$out/runs/$scenario
  echo
  echo "== $scenario"
  run "$bin/radive_simulate" --scenario="$scenario" --seed=1 --frames="$frames" \
    --output="$out/scans/$scenario"
  run "$bin/radive_odometry" --input="$out/scans/$scenario" --config="$config" \
    --set=input.format=raw,input.layout=xyzdp5 --output="$results"
  cp "$out/scans/$scenario/gt_tum.txt" "$results/reference.tum"
  ate_t=$(evaluate "$results" | rmse)
  ate_r=$(evaluate "$results" --relation=angle_deg | rmse)
  summary+=("$(printf 'ATE of %-13s %.3f m  %.3f deg' "$scenario" "$ate_t" "$ate_r")")
  runs+=("$scenario=$results")
done
echo
run "$bin/radive_report" "${runs[@]}" --title "RaDiVe demo: two simulated streets" \
  --output "$out/report"
echo
printf '%s\n' "${summary[@]}"
echo "simulated, estimated, scored and reported in $((SECONDS - begin)) s"
