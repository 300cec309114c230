#!/usr/bin/env bash
# Submits a study to Slurm: an array of SHARDS jobs that each run a part of it, and a job behind them
# that collects the tables. OUTPUT, the study and its data must lie where all nodes see them.
#
#   scripts/slurm_batch.sh STUDY.yaml OUTPUT SHARDS [radive_batch flags] [-- sbatch flags]
#   scripts/slurm_batch.sh configs/studies/paper_ablation_sim.yaml STUDY 8 -- --cpus-per-task=4
#
# Each job runs as many runs at a time as it has CPUs. The same command again goes on with what is
# missing. Prints the number of the collecting job. Logs are in OUTPUT/slurm/.
set -euo pipefail

if [[ $# -lt 3 || ! $3 =~ ^[1-9][0-9]*$ ]]; then
  sed -n '2,/^set /{s/^# \{0,1\}//p}' "$0" >&2
  exit 1
fi
study=$(realpath "$1")
mkdir -p "$2/slurm"
output=$(realpath "$2")
shards=$3
shift 3
batch_flags=()
while [[ $# -gt 0 && $1 != -- ]]; do
  batch_flags+=("$1")
  shift
done
[[ $# -eq 0 ]] || shift

root=$(realpath "$(dirname "$0")/..")
batch=${RADIVE_BUILD_DIR:-$root/build}/apps/radive_batch
if [[ ! -x $batch ]]; then
  batch=$(command -v radive_batch) || {
    echo "slurm_batch.sh: no radive_batch in build/apps (set RADIVE_BUILD_DIR) and none in the PATH" >&2
    exit 1
  }
fi
command=$(printf '%q ' "$batch" "$study" "--output=$output" "${batch_flags[@]}")

# A failed run is no failed job: the collecting job says what failed.
array=$(sbatch --parsable --job-name=radive --array=0-$((shards - 1)) \
  --output="$output/slurm/shard_%a.log" "$@" \
  --wrap="$command --shard=\$SLURM_ARRAY_TASK_ID/$shards --jobs=\${SLURM_CPUS_PER_TASK:-1}")
sbatch --parsable --job-name=radive_collect --dependency="afterany:${array%%;*}" \
  --output="$output/slurm/collect.log" --wrap="$command --collect"
