#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Compiles the permutations of a command line or of a manifest on the nodes of a Slurm cluster: a job array with a task for each part,
# and after it a job that makes one index of all parts.
#   clipc-slurm.sh PARTS FOLDER [SBATCH_OPTION...] -- ARGUMENT...
#   clipc-slurm.sh 200 out --partition=short --cpus-per-task=4 -- --batch=shaders.json
# PARTS: at most 1,000, unless the cluster's MaxArraySize is larger. FOLDER: where the outputs go, which exists and which all nodes see.
# ARGUMENT: what clipc takes, without -o, --index, -j, --shard and --resume. Paths are relative to the current folder, as with clipc.
# CLIPC names the program, `clipc` otherwise. A part whose node is lost runs again on another node, and resumes what it did.
set -euo pipefail

case ${1:-} in
  part) # a task of the array; Slurm runs a copy of this file
    parts=$2 folder=$3
    shift 3
    exec "$CLIPC" "$@" --shard="$SLURM_ARRAY_TASK_ID/$parts" --resume -o "$folder" -j "${SLURM_CPUS_PER_TASK:-1}"
    ;;
  merge) exec "$CLIPC" --shard=merge "$3"/index.*-of-"$2".json ;;
esac

usage() {
  sed -n '5,9s/^# *//p' "$0" >&2
  exit 2
}
[[ ${1:-} =~ ^[1-9][0-9]*$ && -d ${2:-} ]] || usage
parts=$1 folder=$2
shift 2
options=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do options+=("$1") && shift; done
[ $# -gt 1 ] || usage
shift
for argument in "$@"; do
  case $argument in
    -o* | --index* | -j* | --shard* | --resume)
      echo "clipc-slurm: \`$argument\` is this script's own to give: leave it out" >&2
      exit 2
      ;;
  esac
done
CLIPC=$(command -v "${CLIPC:-clipc}") || {
  echo "clipc-slurm: there is no program \`${CLIPC:-clipc}\`; give it as CLIPC=PATH" >&2
  exit 2
}
export CLIPC

# An index of a run before must not stand for a part that never runs. What --resume reads stays.
rm -f -- "$folder"/index.*-of-*.json
array=$(sbatch --parsable --job-name=clipc --array="1-$parts" --requeue --open-mode=append --output="$folder/part-%a.log" \
  "${options[@]}" "$0" part "$parts" "$folder" "$@")
# After the last part, however each ended: the merge says which part is missing or was interrupted.
merge=$(sbatch --parsable --job-name=clipc-merge --dependency="afterany:$array" --output="$folder/merge.log" \
  "${options[@]}" "$0" merge "$parts" "$folder")
echo "parts: job $array; merge: job $merge; logs: $folder/part-N.log, $folder/merge.log"
