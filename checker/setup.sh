# Sourced by checker/run and tests/run: installs what is missing, configures, builds.
# Everything it says goes to standard error, so that the standard output belongs to the program started afterwards.

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
libkainjow-mustache-dev the template of the report page
libseccomp-dev          keeps student code inside its process
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
  say "  Homebrew: brew install cmake ninja eigen fmt nlohmann-json cli11 doctest boost gnuplot doxygen graphviz (and gnuplot-iostream.h and kainjow's mustache.hpp from their authors)"
  say "  Fedora:   dnf install gcc-c++ libstdc++-static glibc-static cmake ninja-build eigen3-devel fmt-devel json-devel cli11-devel doctest-devel boost-devel gnuplot gnuplot-iostream-devel libseccomp-devel doxygen graphviz (and kainjow's mustache.hpp from its author)"
  say "  Arch:     pacman -S base-devel cmake ninja eigen fmt nlohmann-json cli11 doctest boost gnuplot libseccomp doxygen graphviz (and gnuplot-iostream from the user repository, and kainjow's mustache.hpp from its author)"
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
    local log=$build_directory/packages.log
    mkdir -p "$build_directory"
    if ! { $as_root apt-get update && DEBIAN_FRONTEND=noninteractive $as_root $command; } >"$log" 2>&1; then
      tail -n 5 "$log" >&2
      say "The packages could not be installed (the whole story: $log). Check the network, or type: $as_root apt-get update && $as_root $command"
      return 1
    fi
    say "Installed."
  fi
  mkdir -p "$build_directory" && : >"$stamp"
}

configure() {  # $1: a preset of CMakePresets.json; further arguments go to cmake
  local preset=$1 log=$build_directory/configure.log
  shift
  mkdir -p "$build_directory"
  if ! cmake --preset "$preset" "$@" >"$log" 2>&1; then
    sed -n '/CMake Error/,$p' "$log" >&2
    say "Configuring failed (the whole story: $log)."
    return 1
  fi
}

build() {  # targets; shows progress, and nothing at all when there is nothing to do
  local log=$build_directory/build.log
  NINJA_STATUS='[%f of %t] ' ninja -C "$build_directory" "$@" 2>&1 | tee "$log" | show_progress "${build_directory#"$PWD"/}"
  [ "${PIPESTATUS[0]}" -eq 0 ] && return 0
  grep -v '^\[[0-9]* of ' "$log" | head -n 40 >&2
  say "The build failed (the whole story: $log)."
  return 1
}

show_progress() {  # $1: the folder; one line with a bar that is written over and over, on a terminal only
  local line begun= step='^\[([0-9]+) of ([0-9]+)\]' width=40 filled bar
  while IFS= read -r line; do
    [[ $line =~ $step && $line != *"Re-checking globbed"* && $line != *"Re-running CMake"* ]] || continue
    [ -n "$begun" ] || say "Building in $1 (only what changed since the last time) ..."
    begun=yes
    [ -t 2 ] || continue
    width=$(($(tput cols 2>/dev/null || echo 80) - 30))
    width=$((width > 40 ? 40 : width < 5 ? 5 : width))
    filled=$((width * BASH_REMATCH[1] / BASH_REMATCH[2]))
    printf -v bar '%*s' "$filled" ''
    bar=${bar// /#}
    printf -v line '%-*s' "$width" "$bar"
    printf '\r  %s %d of %d ' "${line// /.}" "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" >&2
  done
  [ -z "$begun" ] || ! [ -t 2 ] || printf '\n' >&2
}
