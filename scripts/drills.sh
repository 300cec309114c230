#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The long drills of docs/reliability.md, some hours; inputs come from radive_simulate. Each ends with a
# line TOTAL; those are printed, and all that was said is in the folder $RADIVE_DRILLS.
#
#   scripts/drills.sh           programs in build/apps, or in $RADIVE_BUILD
#   scripts/drills.sh --short   a short form of those that CTest has, in a minute
set -euo pipefail
cd "$(dirname "$0")/.."

kills=200 frames=60 sizes=50 programs=() forms=()
if [[ ${1:-} == --short ]]; then
  kills=3 frames=12 sizes=4 programs=(radive_odometry radive_simulate) forms=(rosbag1 rosbag2 raw)
fi
build=${RADIVE_BUILD:-build/apps}
logs=${RADIVE_DRILLS:-$(mktemp -d -t radive_drills_XXXXXX)}
mkdir -p "$logs"
failed=0

# drill NAME COMMAND...: 77 is a drill that cannot run here.
drill() {
  local name=$1 status=0
  shift
  /usr/bin/python3 -B "$@" >"$logs/$name.log" 2>&1 || status=$?
  grep '^TOTAL' "$logs/$name.log" || tail -n 3 "$logs/$name.log"
  if [[ $status != 0 && $status != 77 ]]; then failed=1; fi
}

drill kill scripts/drills/kill.py "$kills" "$frames" ${programs[@]+"${programs[@]}"}
drill disk scripts/drills/disk.py "$frames" "$sizes" ${programs[@]+"${programs[@]}"}
drill power scripts/drills/power.py "$frames" ${programs[@]+"${programs[@]}"}
drill read_errors scripts/drills/read_errors.py "$frames" ${forms[@]+"${forms[@]}"}
if [[ ${1:-} != --short ]]; then
  drill mutations scripts/drill_mutations.py --programs="$build"
  drill soak scripts/drill_soak.py --programs="$build" --seconds=7200
fi
echo "logs: $logs"
exit $failed
