# The course: a lecture is a folder NN_topic here, an exercise its hints. Only files are looked at: what the cards say, and
# which parts are missing, the checker says (`self-check`); what lacks a part is left out of the build.
#
#   WORKBOOK_LECTURES         their folders, in order
#   <lecture>_exercises       where there are solutions: those that have one and are judged
#   WORKBOOK_CONTRACTS        include/rigid/*.hpp, as they are included
set(parts card.json notes.md worked_examples.cpp figures.cpp)
list(TRANSFORM parts PREPEND ${CMAKE_CURRENT_LIST_DIR}/[0-9][0-9]_*/ OUTPUT_VARIABLE patterns)
file(GLOB found RELATIVE ${CMAKE_CURRENT_LIST_DIR} CONFIGURE_DEPENDS ${patterns})
set(WORKBOOK_LECTURES "")  # an older tree may have a cache entry of this name
foreach(card IN LISTS found)
  cmake_path(GET card PARENT_PATH lecture)
  list(TRANSFORM parts PREPEND ${lecture}/ OUTPUT_VARIABLE wanted)
  list(REMOVE_ITEM wanted ${found})
  if(NOT wanted AND NOT lecture IN_LIST WORKBOOK_LECTURES)
    list(APPEND WORKBOOK_LECTURES ${lecture})
  endif()
endforeach()

foreach(lecture IN LISTS WORKBOOK_LECTURES)
  set(${lecture}_exercises)
  set(solutions ${CMAKE_SOURCE_DIR}/solutions/${lecture})
  file(GLOB sources CONFIGURE_DEPENDS ${solutions}/*.cpp ${solutions}/judging/*.cpp)
  file(GLOB hints CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/${lecture}/hints/*.md)
  foreach(file IN LISTS hints)
    cmake_path(GET file STEM exercise)
    if(NOT WORKBOOK_HAS_SOLUTIONS
       OR (EXISTS ${solutions}/${exercise}.cpp AND EXISTS ${solutions}/judging/${exercise}.cpp))
      list(APPEND ${lecture}_exercises ${exercise})
    endif()
  endforeach()
endforeach()
file(GLOB WORKBOOK_CONTRACTS RELATIVE ${CMAKE_SOURCE_DIR}/include CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/include/rigid/*.hpp)
