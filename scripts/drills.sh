#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The long drills of docs/reliability.md, about half an hour; inputs come from radive_simulate.
#
#   scripts/drills.sh           programs in build/apps, or in $RADIVE_BUILD
#   scripts/drills.sh --short   the same in a minute
set -euo pipefail
cd "$(dirname "$0")/drills"

kills=200 frames=60
if [[ ${1:-} == --short ]]; then kills=3 frames=12; fi
failed=0
python3 kill.py $kills $frames || failed=1
python3 disk.py $frames || [[ $? == 77 ]] || failed=1
python3 power.py $frames || [[ $? == 77 ]] || failed=1
exit $failed
