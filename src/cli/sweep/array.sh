#!/bin/sh
# One task of the array computes one shard, on one core. submit.sh lists the tasks.
#SBATCH --job-name={name}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
# Minutes: twice the planned time of a shard.
#SBATCH --time={limit}
# A task whose node fails, or that is preempted, goes back to the queue; it continues after its last complete block.
#SBATCH --requeue
#SBATCH --open-mode=append
exec {program} --threads 1 --quiet sweep {scene} --shard "$SLURM_ARRAY_TASK_ID/{shards}" --out {out}
