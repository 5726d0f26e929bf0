# Installs what is missing, configures, builds. Sourced by checker/run and tests/run, which it takes to the top folder;
# started as a program it builds: setup.sh FOLDER TARGET...
# Everything it says goes to standard error, so that the standard output belongs to the program started afterwards.

setup_script=$(realpath "${BASH_SOURCE[0]}")
cd "${setup_script%/*/*}" || exit 3

say() { printf '%s\n' "$*" >&2; }

# One line per Debian package: its name and what it is for.
packages_of_the_checker='
g++                     compiles the workbook and the exercises
cmake                   describes the build
ninja-build             runs the build
libeigen3-dev           vectors and matrices of every exercise
libfmt-dev              text formatting
nlohmann-json3-dev      reference results and reports as JSON
libcli11-dev            command line of the checker
doctest-dev             worked examples and tests
libboost-dev            elliptic functions, integrators, automatic differentiation
libboost-iostreams-dev  needed by gnuplot-iostream
libboost-filesystem-dev needed by gnuplot-iostream
libboost-system-dev     needed by gnuplot-iostream
libgnuplot-iostream-dev plots and figures from C++
gnuplot-nox             draws the plots and figures
libsodium-dev           locks solutions in copies for students
libkainjow-mustache-dev the templates of the report pages
libarchive-dev          reads zip files of submissions
libseccomp-dev          filters the system calls of what a student hands in
bubblewrap              isolates the code of a class that is graded
'

missing_packages() {  # the names on standard input that are not installed
  local name
  local installed
  installed=$(dpkg-query -W -f='${db:Status-Abbrev} ${binary:Package}\n' 2>/dev/null | sed -n 's/^ii *//p' | sed 's/:.*//')
  while read -r name _; do
    [ -z "$name" ] || grep -qxF -- "$name" <<<"$installed" || printf '%s\n' "$name"
  done
}

explain_other_systems() {
  say "This script installs packages with apt-get, which this system does not have. Install these yourself, then start again:"
  say "  Homebrew: brew install cmake ninja eigen fmt nlohmann-json cli11 doctest boost libarchive gnuplot doxygen (and gnuplot-iostream.h and kainjow's mustache.hpp from their authors)"
  say "  Fedora:   dnf install gcc-c++ libstdc++-static glibc-static cmake ninja-build eigen3-devel fmt-devel json-devel cli11-devel doctest-devel boost-devel libarchive-devel libseccomp-devel bubblewrap gnuplot gnuplot-iostream-devel doxygen (and kainjow's mustache.hpp from its author)"
  say "  Arch:     pacman -S base-devel cmake ninja eigen fmt nlohmann-json cli11 doctest boost libarchive libseccomp bubblewrap gnuplot doxygen (and gnuplot-iostream from the user repository, and kainjow's mustache.hpp from its author)"
  say "If they are installed already, set WORKBOOK_SKIP_PACKAGES=1 and start again."
}

install_packages() {  # $1: the table of packages; $2: the stamp that remembers that they were all there
  local table=$1 stamp=$2 missing
  [ -z "${WORKBOOK_SKIP_PACKAGES:-}" ] || return 0
  if [ -e "$stamp" ] && [ ! "$setup_script" -nt "$stamp" ]; then return 0; fi
  if ! command -v apt-get >/dev/null; then
    explain_other_systems
    return 1
  fi
  missing=$(missing_packages <<<"$table")
  if [ -n "$missing" ]; then
    say "These Debian packages are missing and will be installed:"
    while read -r name reason; do
      if [ -n "$name" ] && grep -qxF -- "$name" <<<"$missing"; then say "$(printf '  %-24s %s' "$name" "$reason")"; fi
    done <<<"$table"
    local command="apt-get install --yes --no-install-recommends $(tr '\n' ' ' <<<"$missing")"
    local as_root=
    if [ "$(id -u)" -ne 0 ]; then
      if ! command -v sudo >/dev/null; then
        say "Installing needs an administrator, and there is no sudo here. Ask one to type:"
        say "  apt-get update && $command"
        return 1
      fi
      as_root=sudo
    fi
    local log=${stamp%/*}/packages.log
    mkdir -p "${stamp%/*}"
    if ! { $as_root apt-get update && DEBIAN_FRONTEND=noninteractive $as_root $command; } >"$log" 2>&1; then
      tail -n 5 "$log" >&2
      say "The packages could not be installed (the whole output: $log). Check the network, or type: $as_root apt-get update && $as_root $command"
      return 1
    fi
    say "Installed."
    rm -f "${stamp%/*}/build.ninja"  # configured once more, so that what was missing is found
  fi
  { mkdir -p "${stamp%/*}" && : >"$stamp"; } 2>/dev/null || true  # build says what is wrong with the folder
}

build() (  # $1: the folder, build/PRESET; then targets. Says nothing when there is nothing to do.
  folder=$1 log=$1/build.log
  shift
  if ! mkdir -p "$folder" 2>/dev/null || ! { : >>"$log"; } 2>/dev/null; then
    say "$PWD cannot be written: copy the folder to a place of your own and start there."
    return 3
  fi
  trap 'say "Stopped. The next start goes on from here."; exit 130' INT
  exec 9>"$folder/.lock"
  if command -v flock >/dev/null && ! flock --nonblock 9; then
    say "Waiting for another build in $folder ..."
    flock 9
  fi
  # A folder that was copied or moved still names the old one here; everything in it was built for that.
  if [ ! -e "$folder/build.ninja" ] || ! grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$folder/CMakeCache.txt"; then
    rm -f "$folder/build.ninja"
    if ! cmake --preset "${folder##*/}" --fresh >"$log" 2>&1; then
      grep -A 20 'CMake Error' "$log" >&2 || tail -n 5 "$log" >&2
      say "Configuring failed (the whole output: $log)."
      return 3
    fi
  fi
  NINJA_STATUS='[%f/%t %e] ' ninja -C "$folder" "$@" 2>&1 | tee "$log" | show_progress "$folder"
  if [ "${PIPESTATUS[0]}" -eq 0 ]; then
    # What was written before the clock was set back is newer than all that is made of it: it would be built for ever.
    if grep -q '^\[[1-9]' "$log" && touch "$folder/.now"; then
      find checker include lectures solutions tests -newer "$folder/.now" -exec touch {} + 2>/dev/null
    fi
    return 0
  fi
  [ -z "${WORKBOOK_PROGRESS:-}" ] || return 3  # the checker asked, and says what that means
  grep -v '^\[[0-9]*/' "$log" | head -n 40 >&2
  say "The build failed (the whole output: $log)."
  return 3
)

show_progress() {  # $1: the folder. One line that is written over and over; where no terminal is, one every ten seconds.
  local terminal= line text begun= shown=0 finished total elapsed left step='^\[([0-9]+)/([0-9]+) ([0-9]+)'
  if [ -t 2 ] || [ "${WORKBOOK_PROGRESS:-}" = terminal ]; then terminal=yes; fi
  while IFS= read -r line; do
    [[ $line =~ $step && $line != *"Re-checking globbed"* && $line != *"Re-running CMake"* ]] || continue
    finished=${BASH_REMATCH[1]} total=${BASH_REMATCH[2]} elapsed=${BASH_REMATCH[3]}
    [ -n "$begun" ] || say "Building in $1 ..."
    begun=yes
    left=$((finished == 0 ? 0 : elapsed * (total - finished) / finished))
    text="  $finished of $total steps"
    [ "$left" -eq 0 ] || [ "$finished" -lt 3 ] || text+=", about $left s left"
    if [ "$terminal" ]; then
      printf '\r%-40s' "$text" >&2
    elif [ $((elapsed - shown)) -ge 10 ]; then
      say "$text"
      shown=$elapsed
    fi
  done
  if [ -n "$begun" ] && [ "$terminal" ]; then printf '\r%-40s\r' '' >&2; fi
}

if [ "${BASH_SOURCE[0]}" = "$0" ]; then build "$@"; fi
