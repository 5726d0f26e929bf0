# Everything that students' files are compiled and linked with: the precompiled prelude, one worker per exercise, and
# toolchain.json, which tells the checker about them.
#
#   workbook_add_workers(TARGET DIRECTORY <dir> INCLUDE <dir>... EXERCISES <name>=<contract header>...)
#
# makes a target that builds into DIRECTORY:
#
#   prelude.hpp, prelude.hpp.gch   checker/worker/prelude.hpp and the contracts, precompiled
#   NAME.o                         the worker's main of each exercise
#   serve.o, …                     what all workers share
#   toolchain.json
#
# Workers are no CMake targets: they must be compiled with exactly the flags of students' files, whatever the build type,
# sanitizers or coverage of the workbook itself.

include(CheckCXXSourceCompiles)

function(workbook_add_workers target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "DIRECTORY" "INCLUDE;EXERCISES")
  set(sources ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  cmake_path(SET root NORMALIZE ${sources}/../..)
  get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)

  # No -ffast-math, ever: NaN must stay NaN. Uninitialised numbers get a fixed, absurd value, so that the same file gives
  # the same result every time; indices of std::vector are checked.
  set(flags -std=c++20 -O1 -ftrivial-auto-var-init=pattern -D_GLIBCXX_ASSERTIONS)
  foreach(directory IN LISTS eigen)
    list(APPEND flags -isystem ${directory})
  endforeach()
  foreach(directory IN LISTS arg_INCLUDE)
    list(APPEND flags -I ${directory})
  endforeach()
  set(compile ${CMAKE_CXX_COMPILER} ${flags})
  set(own_flags -I ${root} -include ${arg_DIRECTORY}/prelude.hpp)

  # The prelude, with all contracts.
  set(contracts "")
  foreach(exercise IN LISTS arg_EXERCISES)
    string(REGEX REPLACE "^[^=]*=" "" header ${exercise})
    list(APPEND contracts ${header})
  endforeach()
  list(REMOVE_DUPLICATES contracts)
  set(prelude "#include \"${sources}/prelude.hpp\"\n")
  foreach(header IN LISTS contracts)
    string(APPEND prelude "#include <${header}>\n")
  endforeach()
  file(CONFIGURE OUTPUT ${arg_DIRECTORY}/prelude.hpp CONTENT "${prelude}" @ONLY)
  add_custom_command(
    OUTPUT ${arg_DIRECTORY}/prelude.hpp.gch
    COMMAND ${compile} -x c++-header ${arg_DIRECTORY}/prelude.hpp -o ${arg_DIRECTORY}/prelude.hpp.gch
            -MD -MF ${arg_DIRECTORY}/prelude.d -MQ ${arg_DIRECTORY}/prelude.hpp.gch
    DEPENDS ${arg_DIRECTORY}/prelude.hpp
    DEPFILE ${arg_DIRECTORY}/prelude.d
    COMMENT "Precompiling the prelude of ${target}"
    VERBATIM)

  # Compiles one source of a worker.
  macro(worker_object name source)
    add_custom_command(
      OUTPUT ${arg_DIRECTORY}/${name}.o
      COMMAND ${compile} ${own_flags} -c ${source} -o ${arg_DIRECTORY}/${name}.o
              -MD -MF ${arg_DIRECTORY}/${name}.d -MQ ${arg_DIRECTORY}/${name}.o
      DEPENDS ${source} ${arg_DIRECTORY}/prelude.hpp.gch
      DEPFILE ${arg_DIRECTORY}/${name}.d
      COMMENT "Compiling the worker's ${name}"
      VERBATIM)
    list(APPEND objects ${arg_DIRECTORY}/${name}.o)
  endmacro()

  set(objects ${arg_DIRECTORY}/prelude.hpp.gch)
  set(support "")
  foreach(part serve last_words eigen_assertion)
    worker_object(${part} ${sources}/${part}.cpp)
    list(APPEND support ${arg_DIRECTORY}/${part}.o)
  endforeach()
  foreach(exercise IN LISTS arg_EXERCISES)
    string(REGEX MATCH "^([^=]+)=(.+)$" found ${exercise})
    set(name ${CMAKE_MATCH_1})
    set(header ${CMAKE_MATCH_2})
    file(CONFIGURE OUTPUT ${arg_DIRECTORY}/mains/${name}.cpp @ONLY CONTENT
"#include <@header@>

#include \"checker/worker/serve.hpp\"

int main() { return workbook::serve(&rigid::@name@); }
")
    worker_object(${name} ${arg_DIRECTORY}/mains/${name}.cpp)
  endforeach()
  add_custom_target(${target} DEPENDS ${objects})

  # What the checker must know. Including is allowed from where the system, Eigen and the contracts are.
  set(include_directories ${CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES} ${eigen} ${arg_INCLUDE})
  workbook_worker_link_flags(link_flags)
  set(toolchain "{\"format\": 1}")
  foreach(key IN ITEMS flags include_directories support link_flags)
    set(list "[]")
    set(index 0)
    foreach(item IN LISTS ${key})
      workbook_json_string(item "${item}")
      string(JSON list SET "${list}" ${index} "${item}")
      math(EXPR index "${index} + 1")
    endforeach()
    string(JSON toolchain SET "${toolchain}" ${key} "${list}")
  endforeach()
  foreach(pair IN ITEMS "compiler=${CMAKE_CXX_COMPILER}" "nm=${CMAKE_NM}" "workers=${arg_DIRECTORY}"
                        "prelude=${arg_DIRECTORY}/prelude.hpp")
    string(REGEX MATCH "^([^=]+)=(.+)$" found "${pair}")
    workbook_json_string(item "${CMAKE_MATCH_2}")
    string(JSON toolchain SET "${toolchain}" ${CMAKE_MATCH_1} "${item}")
  endforeach()
  file(CONFIGURE OUTPUT ${arg_DIRECTORY}/toolchain.json CONTENT "${toolchain}\n" @ONLY)
endfunction()

# Static, so that a worker opens no file to start; with the quicker linker where there is one, for linking is a good part
# of the time that a student waits.
function(workbook_worker_link_flags result)
  # Not with the flags of the workbook itself: sanitizers cannot be linked statically.
  set(CMAKE_CXX_FLAGS "")
  set(CMAKE_EXE_LINKER_FLAGS "")
  set(CMAKE_REQUIRED_LINK_OPTIONS -static)
  set(program "#include <iostream>\nint main() { std::cout << 1; }")
  check_cxx_source_compiles("${program}" WORKBOOK_LINKS_STATICALLY)
  if(NOT WORKBOOK_LINKS_STATICALLY)
    message(FATAL_ERROR "Students' functions are linked statically, but this compiler cannot do that: "
                        "install the static C and C++ libraries (on Debian: libc6-dev and libstdc++-12-dev).")
  endif()
  set(CMAKE_REQUIRED_LINK_OPTIONS -static -fuse-ld=gold)
  check_cxx_source_compiles("${program}" WORKBOOK_LINKS_WITH_GOLD)
  set(flags -static -s)
  if(WORKBOOK_LINKS_WITH_GOLD)
    list(APPEND flags -fuse-ld=gold)
  endif()
  set(${result} ${flags} PARENT_SCOPE)
endfunction()

# A string as JSON writes it.
function(workbook_json_string result text)
  string(REPLACE "\\" "\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" text "${text}")
  set(${result} "\"${text}\"" PARENT_SCOPE)
endfunction()
