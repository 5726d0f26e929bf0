# What students' files are compiled and linked with, in two kinds: to be judged, and for the diagnostic run that explains
# a failure.
#
#   workbook_add_toolchain(TARGET DIRECTORY <dir> INCLUDE <dir>... CONTRACTS <header>...)
#
# makes the targets TARGET and TARGET_diagnostic, which build into DIRECTORY and DIRECTORY/diagnostic:
#
#   prelude.hpp, prelude.hpp.gch   the contracts, precompiled
#   serve.o, ...                   what all workers share
#   toolchain.json                 tells the checker about them; it compiles the worker's main of an exercise itself
#
# Workers are no CMake targets: they must be compiled with exactly the flags of students' files, whatever the build type,
# sanitizers or coverage of the workbook itself.

include(CheckCXXSourceCompiles)

function(workbook_add_toolchain target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "DIRECTORY" "INCLUDE;CONTRACTS")
  set(sources ${CMAKE_CURRENT_FUNCTION_LIST_DIR})

  # No -ffast-math, ever: NaN must stay NaN. Uninitialised numbers get a fixed, absurd value, so that the same file gives
  # the same result every time; indices of std::vector are checked. No code is generated at the link: the compiler that
  # would do it takes its options from the student's object file.
  workbook_worker_link_flags(link_flags)
  # Columns in bytes; headers by the paths by which they are found. That is how clang says them anyway; it is asked for
  # warnings that only GCC has, and for the list of files that its own assembler does not write.
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    set(messages -fmax-errors=20 -fdiagnostics-column-unit=byte -fno-canonical-system-headers)
  else()
    set(messages -ferror-limit=0 -Wno-unused-command-line-argument -Wno-unknown-warning-option -fno-integrated-as)
  endif()
  # The optimiser takes a path without a return for one that is never taken, and the result for one that is right there.
  set(returns -fsanitize=return -fsanitize-undefined-trap-on-error)
  # So that elliptic integrals of NaN are NaN in a moment, and no time limit.
  set(definitions -D_GLIBCXX_ASSERTIONS -DBOOST_MATH_MAX_SERIES_ITERATION_POLICY=1000)
  workbook_worker_sanitizers(sanitizers)
  set(diagnostic "")
  if(sanitizers)
    set(diagnostic ${arg_DIRECTORY}/diagnostic/toolchain.json)
  endif()
  workbook_add_one_toolchain(${target}
    DIRECTORY ${arg_DIRECTORY} INCLUDE ${arg_INCLUDE} CONTRACTS ${arg_CONTRACTS}
    FLAGS -std=c++20 ${messages} ${returns} -O1 -ftrivial-auto-var-init=pattern ${definitions}
    LINK_FLAGS -static -s -fno-lto ${link_flags}
    PRELUDE "#include \"${sources}/prelude.hpp\"\n"
    PARTS ${sources}/serve.cpp ${sources}/crash_handler.cpp ${sources}/streams.cpp
    MAIN ${sources}/serve.hpp serve
    DIAGNOSTIC "${diagnostic}")

  # For diagnostic runs: not optimised, so that every line is where the student wrote it and memory that was never set is
  # really read. Without sanitizers there are none, and the target makes nothing.
  if(NOT sanitizers)
    add_custom_target(${target}_diagnostic)
    return()
  endif()
  workbook_add_one_toolchain(${target}_diagnostic
    DIRECTORY ${arg_DIRECTORY}/diagnostic INCLUDE ${arg_INCLUDE} CONTRACTS ${arg_CONTRACTS}
    FLAGS -std=c++20 ${messages} -O0 -g1 -fno-omit-frame-pointer -fno-stack-protector ${definitions} ${sanitizers}
    LINK_FLAGS -fno-lto ${link_flags} ${sanitizers}
    PRELUDE "#define WORKBOOK_DIAGNOSE\n#include \"${sources}/prelude.hpp\"\n"
    PARTS ${sources}/serve.cpp ${sources}/diagnostics.cpp ${sources}/streams.cpp
    MAIN ${sources}/serve.hpp serve)
endfunction()

#   PRELUDE     the beginning of the prelude; the contracts follow
#   PARTS       what all workers share
#   MAIN        the header and the function that every worker's main needs: it calls workbook::FUNCTION(&rigid::EXERCISE)
#   DIAGNOSTIC  the toolchain.json of the diagnostic run, if there is one
function(workbook_add_one_toolchain target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "DIRECTORY;PRELUDE;DIAGNOSTIC" "INCLUDE;CONTRACTS;FLAGS;LINK_FLAGS;PARTS;MAIN")
  get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  set(flags ${arg_FLAGS})
  foreach(directory IN LISTS eigen)
    list(APPEND flags -isystem ${directory})
  endforeach()
  foreach(directory IN LISTS arg_INCLUDE)
    list(APPEND flags -I ${directory})
  endforeach()
  set(compile ${CMAKE_CXX_COMPILER} ${flags})
  cmake_path(RELATIVE_PATH arg_DIRECTORY BASE_DIRECTORY ${CMAKE_BINARY_DIR} OUTPUT_VARIABLE shown_directory)

  set(prelude ${arg_DIRECTORY}/prelude.hpp)
  list(TRANSFORM arg_CONTRACTS REPLACE "(.+)" "#include <\\1>\n")
  string(CONCAT text "${arg_PRELUDE}" ${arg_CONTRACTS})
  file(CONFIGURE OUTPUT ${prelude} CONTENT "${text}" @ONLY)
  add_custom_command(
    OUTPUT ${prelude}.gch
    COMMAND ${compile} -x c++-header ${prelude} -o ${prelude}.gch -MD -MF ${arg_DIRECTORY}/prelude.d -MQ ${prelude}.gch
    DEPENDS ${prelude}
    DEPFILE ${arg_DIRECTORY}/prelude.d
    COMMENT "Precompiling the prelude of ${shown_directory}"
    VERBATIM)

  set(support)
  foreach(source IN LISTS arg_PARTS)
    cmake_path(GET source STEM part)
    set(object ${arg_DIRECTORY}/${part})
    add_custom_command(
      OUTPUT ${object}.o
      COMMAND ${compile} -I ${CMAKE_SOURCE_DIR} -include ${prelude} -c ${source} -o ${object}.o -MD -MF ${object}.d -MQ ${object}.o
      DEPENDS ${source} ${prelude}.gch
      DEPFILE ${object}.d
      COMMENT "Compiling ${part} of ${shown_directory}"
      VERBATIM)
    list(APPEND support ${object}.o)
  endforeach()
  add_custom_target(${target} DEPENDS ${prelude}.gch ${support})

  # What the checker must know. Including is allowed from where the system, Eigen and the contracts are.
  set(include_directories ${CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES} ${eigen} ${arg_INCLUDE})
  set(link_flags ${arg_LINK_FLAGS})
  list(POP_FRONT arg_MAIN main_header main_function)
  workbook_json(toolchain compiler=${CMAKE_CXX_COMPILER} nm=${CMAKE_NM} directory=${arg_DIRECTORY} prelude=${prelude}
    main_header=${main_header} main_function=${main_function} main_include=${CMAKE_SOURCE_DIR}
    build=${CMAKE_BINARY_DIR} setup=${CMAKE_SOURCE_DIR}/checker/setup.sh target=${target}
    diagnostic=${arg_DIAGNOSTIC} addr2line=${CMAKE_ADDR2LINE} sources=${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  string(JSON toolchain SET "${toolchain}" format 1)
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

# GCC's sanitizers of memory and of undefined behaviour. Where their libraries are missing there are no diagnostic runs;
# nor with clang, whose sanitizers start another program to name a line, and no sandbox lets them.
function(workbook_worker_sanitizers result)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    set(${result} "" PARENT_SCOPE)
    return()
  endif()
  set(CMAKE_CXX_FLAGS "")
  set(CMAKE_EXE_LINKER_FLAGS "")
  set(flags -fsanitize=address,signed-integer-overflow,integer-divide-by-zero,float-divide-by-zero,float-cast-overflow
            -fsanitize=shift,bounds,return)
  string(JOIN " " CMAKE_REQUIRED_FLAGS ${flags})
  set(CMAKE_REQUIRED_LINK_OPTIONS ${flags})
  check_cxx_source_compiles("int f(int n) { int numbers[3] = {}; return numbers[n + 1]; } int main(int n, char**) { return f(n); }"
                            WORKBOOK_HAS_SANITIZERS)
  if(NOT WORKBOOK_HAS_SANITIZERS)
    set(flags "")
  endif()
  set(${result} ${flags} PARENT_SCOPE)
endfunction()

# An object of JSON from KEY=TEXT...
function(workbook_json result)
  set(object "{}")
  foreach(pair IN LISTS ARGN)
    string(REGEX MATCH "^([^=]+)=(.*)$" found "${pair}")
    workbook_json_string(text "${CMAKE_MATCH_2}")
    string(JSON object SET "${object}" ${CMAKE_MATCH_1} "${text}")
  endforeach()
  set(${result} "${object}" PARENT_SCOPE)
endfunction()

# A string as JSON writes it.
function(workbook_json_string result text)
  string(REPLACE "\\" "\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" text "${text}")
  set(${result} "\"${text}\"" PARENT_SCOPE)
endfunction()
