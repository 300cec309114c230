#!/usr/bin/env bash
# Runs a small study through scripts/slurm_batch.sh on a Slurm of its own on this machine (munged,
# slurmctld and slurmd in a scratch folder) and compares its results.csv with that of a local run.
# Exit status 77: skipped, with the reason.
#
#   scripts/test_slurm.sh [BUILD]
set -euo pipefail
cd "$(dirname "$0")/.."
build=$(realpath "${1:-build}")

skip() {
  echo "skipped: $1"
  exit 77
}

for program in munged slurmctld slurmd sbatch squeue scontrol; do
  PATH=$PATH:/usr/sbin command -v "$program" >/dev/null ||
    skip "$program is missing (apt-get install slurmctld slurmd slurm-client munge)"
done
[[ $(id -u) -eq 0 ]] || skip "slurmd needs root"
export PATH=$PATH:/usr/sbin

scratch=$(mktemp -d)
pids=()
cleanup() {
  status=$?
  if [[ $status -ne 0 ]]; then tail -n 20 "$scratch"/*.log "$scratch"/out/slurm/*.log 2>/dev/null; fi
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
  for pid in "${pids[@]}"; do wait "$pid" 2>/dev/null || true; done
  rm -rf "$scratch"
  exit "$status"
}
trap cleanup EXIT

wait_for() { # SECONDS WHAT COMMAND...
  local tries=$((10 * $1)) what=$2
  shift 2
  for ((i = 0; i < tries; ++i)); do
    if "$@" >/dev/null 2>&1; then return; fi
    sleep 0.1
  done
  echo "test_slurm.sh: $what did not come up" >&2
  return 1
}

# A port that nobody listens on. (Between here and the start of the daemons somebody might.)
free_port() {
  python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])'
}

# munged wants its folders to belong to it and to be closed to others.
chmod 755 "$scratch"
mkdir -p "$scratch"/{munge,state,spool}
chmod 711 "$scratch/munge"
dd if=/dev/urandom of="$scratch/munge/key" bs=1 count=1024 status=none
chmod 400 "$scratch/munge/key"
munged --foreground --force --key-file="$scratch/munge/key" --socket="$scratch/munge/socket" \
  --pid-file="$scratch/munge/pid" --log-file="$scratch/munge/log" --seed-file="$scratch/munge/seed" \
  --num-threads=2 >"$scratch/munged.log" 2>&1 &
pids+=($!)
wait_for 10 munged test -S "$scratch/munge/socket"

host=$(hostname -s)
cat >"$scratch/slurm.conf" <<CONF
ClusterName=radive
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
AuthType=auth/munge
AuthInfo=socket=$scratch/munge/socket
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/spool
SlurmctldPidFile=$scratch/slurmctld.pid
SlurmdPidFile=$scratch/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SchedulerParameters=batch_sched_delay=0,sched_interval=2
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP OverSubscribe=YES
CONF
cat >"$scratch/cgroup.conf" <<CONF
CgroupPlugin=cgroup/v1
CgroupAutomount=no
ConstrainCores=no
CONF
export SLURM_CONF=$scratch/slurm.conf
slurmctld -D -f "$SLURM_CONF" >"$scratch/slurmctld.log" 2>&1 &
pids+=($!)
wait_for 20 slurmctld scontrol ping
slurmd -D -f "$SLURM_CONF" -N "$host" >"$scratch/slurmd.log" 2>&1 &
pids+=($!)
wait_for 20 slurmd sh -c "sinfo --noheader --format=%T | grep -q idle"

cat >"$scratch/study.yaml" <<STUDY
seeds: 0-2
set: {input.format: raw, input.layout: xyzdp5, input.rate: 20, output.map: none}
evaluate: {align: origin}
sequences:
  - {scenario: street_sparse, simulate: {frames: 30}}
variants:
  - name: ours
  - {name: plain, set: {ego_velocity.weights: false}}
STUDY
"$build/apps/radive_batch" "$scratch/study.yaml" --output="$scratch/local" --quiet
job=$(RADIVE_BUILD_DIR=$build scripts/slurm_batch.sh "$scratch/study.yaml" "$scratch/out" 2)
wait_for 120 "the collecting job" sh -c "scontrol show job ${job%%;*} | grep -q JobState=COMPLETED"
for shard in 0 1; do
  grep -q "runs: 3 ok" "$scratch/out/slurm/shard_$shard.log"
done
cmp "$scratch/local/results.csv" "$scratch/out/results.csv"
echo "2 shards through Slurm $(slurmctld -V | cut -d' ' -f2): results.csv as of a local run"
