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
libboost-regex-dev      finds patterns in long texts
libgnuplot-iostream-dev plots and figures from C++
gnuplot-nox             draws the plots and figures
libsodium-dev           locks solutions in copies for students
libkainjow-mustache-dev the templates of the report pages
libarchive-dev          reads zip files of submissions
libyaml-cpp-dev         reads whose submissions Gradescope exports
libicu-dev              compares the names of students
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
  say "  Homebrew: brew install cmake ninja eigen fmt nlohmann-json cli11 doctest boost libarchive yaml-cpp icu4c gnuplot doxygen (and gnuplot-iostream.h and kainjow's mustache.hpp from their authors)"
  say "  Fedora:   dnf install gcc-c++ libstdc++-static glibc-static cmake ninja-build eigen3-devel fmt-devel json-devel cli11-devel doctest-devel boost-devel libarchive-devel yaml-cpp-devel libicu-devel libseccomp-devel bubblewrap gnuplot gnuplot-iostream-devel doxygen (and kainjow's mustache.hpp from its author)"
  say "  Arch:     pacman -S base-devel cmake ninja eigen fmt nlohmann-json cli11 doctest boost libarchive yaml-cpp icu libseccomp bubblewrap gnuplot doxygen (and gnuplot-iostream from the user repository, and kainjow's mustache.hpp from its author)"
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

build() {  # $1: the folder, build/PRESET; then targets. Says nothing when there is nothing to do.
  local folder=$1 status
  if ! mkdir -p "$folder" 2>/dev/null || ! : 2>/dev/null >>"$folder/build.log"; then
    say "$PWD cannot be written: copy the folder to a place of your own and start there."
    return 3
  fi
  trap 'say "Stopped. The next start goes on from here."; exit 130' INT
  build_alone "$@" 9>>"$folder/.lock"
  status=$?
  trap - INT
  return $status
}

# As build. Nobody else builds in the folder while this process, or one that reads what ninja says, has descriptor 9.
build_alone() {
  local folder=$1 log=$1/build.log begun title announced= tied= plan
  shift
  title=$(title_of "$@")
  # However this process ends, ninja is told, and ends what it has started.
  ! command -v setpriv >/dev/null || tied='setpriv --pdeathsig TERM'
  ! command -v flock >/dev/null || flock --nonblock 9 || wait_for_other_build
  printf -v begun '%(%s)T'
  printf '%s\n' "$begun" "$title" >"$folder/.now"
  # All that CMake writes names the folder where it lies.
  if [ ! -e "$folder/build.ninja" ] || ! grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$folder/CMakeCache.txt"; then
    [ ! -e "$folder/build.ninja" ] || say "This folder was copied or moved: what was built in its old place is built again for this one."
    announce
    rm -f "$folder/build.ninja"
    if ! $tied cmake --preset "${folder##*/}" --fresh >"$log" 2>&1 9>&-; then
      grep -A 20 'CMake Error' "$log" >&2 || tail -n 5 "$log" >&2
      say "Configuring failed (the whole output: $log)."
      return 3
    fi
  fi
  # By its full path ninja does not find its own file among its targets; else it would stop where that may be out of date.
  plan=$(NINJA_STATUS='[%f/%t] ' ninja -C "$folder" -f "$PWD/$folder/build.ninja" -n "$@" 2>/dev/null 9>&-)
  # One step for each processor: the time that is left is told from that.
  NINJA_STATUS='[%f/%t %e] ' $tied ninja -j "$(nproc)" -C "$folder" "$@" 2>&1 9>&- | tee "$log" | show_progress "$plan" "$folder/.now"
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
}

title_of() {  # what the targets are to somebody who waits for them
  local target lecture name text=
  for target; do
    lecture=
    [[ ! $target =~ _([0-9][0-9])_ ]] || lecture="lecture ${BASH_REMATCH[1]}"
    case $target in
      checker) name='the checker' ;;
      all_commands) name='the commands that are typed less often' ;;
      *_diagnostic) name='what finds the line of a mistake' ;;
      reference_results_*) name="the reference results of $lecture" ;;
      worked_examples_*) name="the worked examples of $lecture" ;;
      draw_* | figures_*) name="the figures of $lecture" ;;
      notes) name='the notes' ;;
      live_of_the_student) name='the live figures' ;;
      handed_out) name='what students get' ;;
      workbook_tests) name='the tests' ;;
      *) continue ;;
    esac
    text+="${text:+ and }$name"
  done
  printf '%s' "${text:-the workbook}"
}

has_terminal() { [ "${WORKBOOK_PROGRESS:-}" = terminal ] || [[ -t 2 && -z "${WORKBOOK_PLAIN:-}" ]]; }

show_line() {  # $1: a line that is written over and over; where no terminal is, one every ten seconds
  if has_terminal; then
    printf '\r\033[K%s' "$1" >&2
  elif [ $((SECONDS - shown_at)) -ge 10 ]; then
    say "$1"
    shown_at=$SECONDS
  fi
}

clear_line() { ! has_terminal || printf '\r\033[K' >&2; }  # of ours, or of the checker

announce() {
  [ -z "$announced" ] || return 0
  announced=yes
  clear_line
  say "Building $title, once ..."
}

wait_for_other_build() {
  local begun title text told= shown_at=$SECONDS
  until flock --timeout 1 9; do
    { read -r begun; read -r title; read -r text; } 2>/dev/null <"$folder/.now"
    [ -n "$title" ] || continue
    if [ "$told" != "$title" ]; then
      clear_line
      say "Waiting for another build: $title ..."
      told=$title
    fi
    show_line "  for $(($(printf '%(%s)T') - begun)) s${text:+; $text}"
  done
  clear_line
}

# Seconds of a processor that a step takes, by what ninja says of it: the first line that fits. Only the ratios matter.
costs_of_steps='
*/unity_source_compile*                           27
*/unity_judging*                                  24
*/unity_grading*                                  18
*/unity_commands_on_demand*                       14
*/workbook_command_line.dir/*                     10
*/workbook_judging.dir/*                           6
*/reference_@(03|05|09|11)_*/Unity/*              19
*/reference_*/Unity/*                              8
*/solutions_@(05|09|10|11)_*/Unity/*               6
*/solutions_*/Unity/*                              3
*.gch                                              6
*worked_examples_objects_@(02|07|08|09|10|11)_*    8
*worked_examples_objects_*                         3
*figures_objects_@(06|10|11)_*                    12
*figures_objects_*                                 3
*lectures/*/support/motion*                        5
*/test_judging.dir/*                              16
*tests/*/Unity/*                                   7
*Building?CXX?object*                              3
WebAssembly*                                      10
Precompiling*                                      6
Reference*@(05|09|10)_*                            3
Figures?of?@(02|06|09|10)_*                        6
Figures*                                           2
Notes*                                             5
Reference*                                         1
Linking?CXX?executable*                            1
*                                                  0
'

# A line of progress from what ninja says. What is left is told from a twentieth of the work on: by the time that the
# finished steps took. Those that run are taken to be the next of the plan, one for each processor.
show_progress() {  # $1: what ninja plans; $2: the file in which others see how far it is
  local line text name pattern cost now spent running i processors left age expected rest credit longest shown_at=$SECONDS work=0 total=0
  local step='^\[([0-9]+)/([0-9]+)( [0-9]+)?[.0-9]*\] (.*)' unfinished=() started=()
  local -A place_of=()
  processors=$(nproc)
  while IFS= read -r line; do
    [[ $line =~ $step ]] || continue
    name=${BASH_REMATCH[4]}
    while read -r pattern cost; do
      [[ -z $pattern || $name != $pattern ]] || break
    done <<<"$costs_of_steps"
    [ ${#unfinished[@]} -ge "$processors" ] || started+=(0)
    place_of[$name]=${#unfinished[@]}
    unfinished+=("$cost")
    total=$((total + cost))
  done <<<"$1"
  [ "$total" -le 3 ] || announce
  while IFS= read -r line; do
    [[ $line =~ $step && $line != *"Re-checking globbed"* && $line != *"Re-running CMake"* ]] || continue
    text="  ${BASH_REMATCH[1]} of ${BASH_REMATCH[2]} steps" now=$((BASH_REMATCH[3])) name=${BASH_REMATCH[4]}
    if i=${place_of[$name]:-} && [ -n "$i" ]; then
      work=$((work + unfinished[i]))
      unset "unfinished[i]"
    fi
    running=0 spent=$((processors * now))  # seconds of processors on the finished steps
    for i in "${!unfinished[@]}"; do
      [ $((running += 1)) -le "$processors" ] || break
      spent=$((spent - (now - ${started[i]:=$now})))
    done
    if [ $((work * 20)) -ge "$total" ] && [ "$work" -lt "$total" ] && [ "$spent" -gt 0 ]; then
      # A step that takes longer than expected has a fifth of its age left; it does not shorten what comes after it.
      running=0 credit=0 longest=1
      for i in "${!unfinished[@]}"; do
        [ $((running += 1)) -le "$processors" ] || break
        age=$((now - started[i])) expected=$((unfinished[i] * spent / work))
        rest=$((age * 6 < expected * 5 ? expected - age : age / 5))
        credit=$((credit + expected - rest)) longest=$((rest > longest ? rest : longest))
      done
      left=$((((total - work) * spent / work - credit) / processors))
      text+=", about $((left > longest ? left : longest)) s left"  # a step has one processor
    fi
    printf '%s\n' "$begun" "$title" "$text" >"$2"
    [ -n "$announced" ] || [ "$now" -ge 1 ] || continue
    announce
    show_line "$text"
  done
  [ -z "$announced" ] || clear_line
}

if [ "${BASH_SOURCE[0]}" = "$0" ]; then build "$@"; fi
