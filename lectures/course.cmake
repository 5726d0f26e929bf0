# The course: its lectures in order, one line each. All else about a lecture is read from its card.
set(WORKBOOK_LECTURES
    01_frame_derivatives
    02_rotating_frames
    03_inertia_tensor
    04_parallel_axis
    05_euler_equations
    06_free_tops
    07_euler_angles
    08_kinetic_energy
    CACHE STRING "the lectures of the course, in order")

# Reads lectures/LECTURE/card.json and defines LECTURE_contract and LECTURE_exercises in the caller's scope.
# Configuring stops when a part is missing or a file lies about that no card lists.
function(workbook_read_card lecture)
  set(folder ${CMAKE_SOURCE_DIR}/lectures/${lecture})
  if(NOT EXISTS ${folder}/card.json)
    message(FATAL_ERROR "lectures/${lecture}/card.json is missing: write the card, or take ${lecture} off the list in lectures/course.cmake.")
  endif()
  set_property(DIRECTORY ${CMAKE_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder}/card.json)
  file(READ ${folder}/card.json card)
  string(JSON contract ERROR_VARIABLE problem GET "${card}" contract)
  if(problem)
    message(FATAL_ERROR "lectures/${lecture}/card.json cannot be read: ${problem}")
  endif()
  string(JSON count ERROR_VARIABLE problem LENGTH "${card}" exercises)
  if(problem)
    message(FATAL_ERROR "lectures/${lecture}/card.json has no list of exercises: ${problem}")
  endif()
  set(exercises)
  math(EXPR last "${count} - 1")
  foreach(index RANGE ${last})
    string(JSON name GET "${card}" exercises ${index} name)
    list(APPEND exercises ${name})
  endforeach()

  set(expected card.json notes.md worked_examples.cpp figures.cpp)
  if(WORKBOOK_HAS_SOLUTIONS)
    foreach(exercise IN LISTS exercises)
      list(APPEND expected exercises/${exercise}.cpp exercises/${exercise}.hints.md)
    endforeach()
    workbook_require(${folder} "lectures/${lecture}" "${expected}")
    workbook_refuse_others(${folder} "lectures/${lecture}" "${expected}")
    set(expected judging.cpp)
    foreach(exercise IN LISTS exercises)
      list(APPEND expected ${exercise}.cpp)
    endforeach()
    workbook_require(${CMAKE_SOURCE_DIR}/solutions/${lecture} "solutions/${lecture}" "${expected}")
    workbook_refuse_others(${CMAKE_SOURCE_DIR}/solutions/${lecture} "solutions/${lecture}" "${expected}")
  else()
    # Students may keep files of their own here, and may lose an exercise: `checker reset` puts it back.
    workbook_require(${folder} "lectures/${lecture}" "${expected};handed_out/reference.json;handed_out/printed.txt")
  endif()
  if(NOT EXISTS ${CMAKE_SOURCE_DIR}/include/rigid/${contract}.hpp)
    message(FATAL_ERROR "include/rigid/${contract}.hpp is missing: the card of ${lecture} names it as the contract.")
  endif()

  set(${lecture}_contract ${contract} PARENT_SCOPE)
  set(${lecture}_exercises ${exercises} PARENT_SCOPE)
endfunction()

# Stops unless FOLDER holds the EXPECTED files.
function(workbook_require folder shown expected)
  foreach(file IN LISTS expected)
    if(NOT EXISTS ${folder}/${file})
      message(FATAL_ERROR "${shown}/${file} is missing, though the card names it: write it, or take it off the card.")
    endif()
  endforeach()
endfunction()

# Stops if FOLDER holds files that are not EXPECTED. Dot-files and editors' backups do not count.
function(workbook_refuse_others folder shown expected)
  file(GLOB_RECURSE found RELATIVE ${folder} CONFIGURE_DEPENDS ${folder}/*)
  list(FILTER found EXCLUDE REGEX "(^|/)\\.|~$|\\.orig$")
  foreach(file IN LISTS found)
    if(NOT file IN_LIST expected)
      message(FATAL_ERROR "${shown}/${file} is on no card: add its exercise to the card, or move the file away.")
    endif()
  endforeach()
endfunction()

foreach(lecture IN LISTS WORKBOOK_LECTURES)
  workbook_read_card(${lecture})
endforeach()
