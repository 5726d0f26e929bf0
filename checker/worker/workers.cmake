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
#   second_look/                   the same once more, for looking at failures instead of judging
#
# Workers are no CMake targets: they must be compiled with exactly the flags of students' files, whatever the build type,
# sanitizers or coverage of the workbook itself.

include(CheckCXXSourceCompiles)

function(workbook_add_workers target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "DIRECTORY" "INCLUDE;EXERCISES")
  set(sources ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  cmake_path(SET witness NORMALIZE ${sources}/instrumented)

  # No -ffast-math, ever: NaN must stay NaN. Uninitialised numbers get a fixed, absurd value, so that the same file gives
  # the same result every time; indices of std::vector are checked.
  workbook_worker_link_flags(link_flags)
  set(second_look ${arg_DIRECTORY}/second_look/toolchain.json)
  workbook_add_worker_set(judging
    DIRECTORY ${arg_DIRECTORY} INCLUDE ${arg_INCLUDE} EXERCISES ${arg_EXERCISES}
    FLAGS -std=c++20 -O1 -ftrivial-auto-var-init=pattern -D_GLIBCXX_ASSERTIONS
    LINK_FLAGS -static -s ${link_flags}
    PRELUDE "#include \"${sources}/prelude.hpp\"\n"
    PARTS ${sources}/serve.cpp ${sources}/crash_handler.cpp ${sources}/eigen_assertion.cpp
    MAIN "checker/worker/serve.hpp" serve
    KEYS "second_look=${second_look}" "addr2line=${CMAKE_ADDR2LINE}")

  # Not optimised, so that every line is where the student wrote it and memory that was never set is really read; the
  # linker sends to the witness what it wants to know of. See checker/second_look.
  workbook_worker_sanitizers(sanitizers)
  set(wrapped malloc __cxa_throw exit _exit _Exit quick_exit __assert_fail)
  list(TRANSFORM wrapped PREPEND -Wl,--wrap=)
  workbook_add_worker_set(looking
    DIRECTORY ${arg_DIRECTORY}/second_look INCLUDE ${arg_INCLUDE} EXERCISES ${arg_EXERCISES}
    FLAGS -std=c++20 -O0 -g1 -fno-omit-frame-pointer -fno-stack-protector -D_GLIBCXX_ASSERTIONS ${sanitizers}
    LINK_FLAGS -static ${link_flags} ${wrapped}
    PRELUDE "#define EIGEN_FUNCTORS_PLUGIN \"${witness}/eigen_implies.hpp\"\n#include \"${witness}/prelude.hpp\"\n"
    PARTS ${witness}/look.cpp ${witness}/eyes.cpp ${witness}/memory.cpp ${witness}/undefined.cpp
    MAIN "checker/worker/instrumented/look.hpp" look)

  add_custom_target(${target} DEPENDS ${judging} ${looking})
endfunction()

# One set of workers, for one way of compiling students' files. Sets RESULT to all that must be built.
#   PRELUDE   the beginning of the prelude; the contracts follow
#   MAIN      the header and the function that every worker's main needs: it calls FUNCTION(&rigid::EXERCISE)
#   KEYS      more for toolchain.json, KEY=TEXT
function(workbook_add_worker_set result)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "DIRECTORY;PRELUDE" "INCLUDE;EXERCISES;FLAGS;LINK_FLAGS;PARTS;MAIN;KEYS")
  cmake_path(SET root NORMALIZE ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../..)
  get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  set(flags ${arg_FLAGS})
  foreach(directory IN LISTS eigen)
    list(APPEND flags -isystem ${directory})
  endforeach()
  foreach(directory IN LISTS arg_INCLUDE)
    list(APPEND flags -I ${directory})
  endforeach()
  set(compile ${CMAKE_CXX_COMPILER} ${flags})
  set(own_flags -I ${root} -include ${arg_DIRECTORY}/prelude.hpp)
  cmake_path(RELATIVE_PATH arg_DIRECTORY BASE_DIRECTORY ${CMAKE_BINARY_DIR} OUTPUT_VARIABLE shown_directory)

  # The prelude, with all contracts.
  set(contracts "")
  foreach(exercise IN LISTS arg_EXERCISES)
    string(REGEX REPLACE "^[^=]*=" "" header ${exercise})
    list(APPEND contracts ${header})
  endforeach()
  list(REMOVE_DUPLICATES contracts)
  set(prelude "${arg_PRELUDE}")
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
    COMMENT "Precompiling the prelude of ${shown_directory}"
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
  foreach(source IN LISTS arg_PARTS)
    cmake_path(GET source STEM part)
    worker_object(${part} ${source})
    list(APPEND support ${arg_DIRECTORY}/${part}.o)
  endforeach()
  list(POP_FRONT arg_MAIN main_header main_function)
  foreach(exercise IN LISTS arg_EXERCISES)
    string(REGEX MATCH "^([^=]+)=(.+)$" found ${exercise})
    set(name ${CMAKE_MATCH_1})
    set(header ${CMAKE_MATCH_2})
    file(CONFIGURE OUTPUT ${arg_DIRECTORY}/mains/${name}.cpp @ONLY CONTENT
"#include <@header@>

#include \"@main_header@\"

int main() { return workbook::@main_function@(&rigid::@name@); }
")
    worker_object(${name} ${arg_DIRECTORY}/mains/${name}.cpp)
  endforeach()
  set(${result} ${objects} PARENT_SCOPE)

  # What the checker must know. Including is allowed from where the system, Eigen and the contracts are.
  set(include_directories ${CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES} ${eigen} ${arg_INCLUDE})
  set(link_flags ${arg_LINK_FLAGS})
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
                        "prelude=${arg_DIRECTORY}/prelude.hpp" LISTS arg_KEYS)
    string(REGEX MATCH "^([^=]+)=(.*)$" found "${pair}")
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
  set(flags "")
  if(WORKBOOK_LINKS_WITH_GOLD)
    list(APPEND flags -fuse-ld=gold)
  endif()
  set(${result} ${flags} PARENT_SCOPE)
endfunction()

# The compiler's own checks of undefined behaviour; without its library, for the witness has its own. Where the compiler
# does not know them, the second look notices less.
function(workbook_worker_sanitizers result)
  set(CMAKE_CXX_FLAGS "")
  set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
  set(flags -fsanitize=signed-integer-overflow,integer-divide-by-zero,float-cast-overflow,shift,bounds,return)
  set(CMAKE_REQUIRED_FLAGS ${flags})
  check_cxx_source_compiles("int f(int n) { int numbers[3] = {}; return numbers[n + 1]; }" WORKBOOK_KNOWS_SANITIZERS)
  if(WORKBOOK_KNOWS_SANITIZERS)
    set(${result} ${flags} PARENT_SCOPE)
  else()
    set(${result} "" PARENT_SCOPE)
  endif()
endfunction()

# A string as JSON writes it.
function(workbook_json_string result text)
  string(REPLACE "\\" "\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" text "${text}")
  set(${result} "\"${text}\"" PARENT_SCOPE)
endfunction()
