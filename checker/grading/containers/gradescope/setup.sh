#!/usr/bin/env bash
# Gradescope starts this once, as root, when it makes the image; the zip file lies unpacked in /autograder/source.
set -eu
cd "$(dirname "$(realpath "$0")")"
[ ! -d source/workbook ] || cd source
# What Ubuntu 22.04 has is too old.
if [ "$(. /etc/os-release && echo "$ID $VERSION_ID")" = 'ubuntu 22.04' ]; then
  DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends g++-12 python3-pip
  update-alternatives --install /usr/bin/c++ c++ /usr/bin/g++-12 100
  update-alternatives --install /usr/bin/g++ g++ /usr/bin/g++-12 100
  pip3 install 'cmake>=3.25,<4'
fi
chmod -R a+rX .
workbook/checker/run doctor
# Builds what a first grading needs, and shows that it works: somebody who has handed in nothing.
mkdir -p /tmp/nothing
workbook/checker/grading/containers/grade.sh gradescope /tmp/nothing cases /tmp/results.json
