#!/usr/bin/env bash
# From nothing to a scored trajectory: installs what is missing, builds, simulates a street with a
# dense and a sparse radar, estimates the drives, prints their errors and draws them.
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
scripts/build.sh -DRADIVE_BUILD_APPS=ON >"$log" 2>&1 || {
  cat "$log" >&2
  exit 1
}

# The first poses are laid on each other: over a few hundred metres of almost straight road, a fit
# of the positions leaves the roll open.
#
# A scenario, and the settings of the real sensor that it imitates. The simulator writes raw
# x y z doppler power records.
for pair in street_dense:mscrad4r street_sparse:hercules_ars548; do
  scenario=${pair%%:*}
  config=configs/${pair##*:}.yaml
  echo
  echo "== $scenario"
  rm -rf "${out:?}/$scenario"
  mkdir -p "$out/$scenario"
  run "$bin/radive_simulate" --scenario="$scenario" --seed=1 --frames="$frames" \
    --output="$out/$scenario/scans"
  run "$bin/radive_odometry" --input="$out/$scenario/scans" --config="$config" \
    --set=input.format=raw,input.layout=xyzdp5 --output="$out/$scenario/results"
  echo "position errors, from the first pose on [m]:"
  run "$bin/radive_evaluate" --reference="$out/$scenario/scans/gt_tum.txt" \
    --estimate="$out/$scenario/results/trajectory_tum.txt" --align=origin
  echo "rotation errors, from the first pose on [deg]:"
  run "$bin/radive_evaluate" --reference="$out/$scenario/scans/gt_tum.txt" \
    --estimate="$out/$scenario/results/trajectory_tum.txt" --align=origin --relation=angle_deg
  run scripts/plot_run.py --results="$out/$scenario/results" \
    --reference="$out/$scenario/scans/gt_tum.txt" --output="$out/$scenario/plots"
done
