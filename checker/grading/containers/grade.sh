#!/usr/bin/env bash
# Judges one submission where a learning system runs its grader: grade.sh FORM SUBMISSION CASES FILE
# SUBMISSION is a folder or a zip file, CASES a folder that `export` made of the assignment. FILE gets what the system
# reads, in the FORM that `grade` has of that name. If the checker itself fails, there is no FILE and the status is 3:
# the system then reports an error, and nobody gets a zero for it.
set -eu
form=$1 submission=$(realpath "$2") cases=$(realpath "$3") file=$(realpath -m "$4")
cd "$(dirname "$(realpath "$0")")/../../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# Root gives up its rights before it grades: what it needs is readable to everybody.
mkdir -p "$work/class/student"
cp -r --no-dereference "$submission" "$work/class/student/"
cp -r "$cases" "$work/cases"
chmod -R a+rX "$work"
export WORKBOOK_PROGRAM=./checker/run
status=0
build/workbook/checker/checker grade "$work/class" --out "$work/out" --assignment "$work/cases/assignment.json" \
  --reference "$work"/cases/*_*.json --allow-reduced || status=$?
[ "$status" -le 1 ] || exit 3
mkdir -p "${file%/*}"
cp "$work/out/$form"/student.* "$file"
