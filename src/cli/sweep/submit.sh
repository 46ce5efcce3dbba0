#!/bin/sh
# Submits the array, and the merge after it.
#   sh submit.sh           all {shards} shards, 0 to {last}
#   sh submit.sh 3,17-19   only these: what `merge {out} --shards {shards} --missing` prints
# A cluster takes arrays up to its MaxArraySize (`scontrol show config`); `sweep --slurm --shards N` makes fewer.
set -eu
tasks=${{1:-0-{last}}}
array=$(sbatch --parsable --array="$tasks" --output={out}/shard-%a.log {out}/array.sh)
merge=$(sbatch --parsable --dependency="afterany:${{array%%;*}}" --output={out}/merge-%j.log {out}/merge.sh)
echo "array $array, merge $merge, program {program}"
