#!/bin/sh
# Joins the blocks after all tasks of the array have ended, also if some failed.
# If blocks are missing, exits with 1 and names the shards to submit again in its log.
#SBATCH --job-name={name}-merge
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --requeue
exec {program} merge {out} --shards {shards} -o {out}/merged.csv
