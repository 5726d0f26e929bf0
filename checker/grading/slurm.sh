#!/usr/bin/env bash
#SBATCH --job-name=grade --output=grade-%A-%a.log --open-mode=append --requeue
# Grades a large class on a Slurm cluster: in parts, of which one that is stopped goes on where it was, then all joined.
# Where no array is, it joins. Submit from the folder of the workbook, built there with ./checker/run doctor, on a file
# system that all nodes share:
#   parts=$(sbatch --parsable --array=1-100 --cpus-per-task=16 checker/grading/slurm.sh SUBMISSIONS FOLDER OPTIONS)
#   sbatch --dependency=afterany:$parts --cpus-per-task=16 checker/grading/slurm.sh SUBMISSIONS FOLDER OPTIONS
# The OPTIONS of `grade` must be the same in both, with a --seed that students do not know. What parts have left undone,
# the second job does.
set -eu
submissions=$1 folder=$2 part=${SLURM_ARRAY_TASK_ID:-}
shift 2
export WORKBOOK_PROGRAM=./checker/run
grade() { exec build/workbook/checker/checker grade "$submissions" --out "$@"; }
[ -z "$part" ] || grade "$folder.parts/$part" --shard "$part/$SLURM_ARRAY_TASK_COUNT" "$@"
grade "$folder" "$@" --merge "$folder".parts/*
