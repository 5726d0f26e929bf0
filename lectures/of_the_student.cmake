# Worked examples and figures on the student's own functions, for `checker examples` and `checker figures`: by the end of the course the student has written
# rigid::rigid.
set(exercise_files)
foreach(lecture IN LISTS WORKBOOK_LECTURES)
  foreach(exercise IN LISTS ${lecture}_exercises)
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${lecture}/exercises/${exercise}.cpp)
      list(APPEND exercise_files ${lecture}/exercises/${exercise}.cpp)
    else()
      message(WARNING "lectures/${lecture}/exercises/${exercise}.cpp is missing: `checker reset ${exercise}` puts it back.")
    endif()
  endforeach()
endforeach()
add_library(exercises_of_the_student OBJECT EXCLUDE_FROM_ALL ${exercise_files})
target_link_libraries(exercises_of_the_student PRIVATE rigid_contracts)
target_precompile_headers(exercises_of_the_student PRIVATE <Eigen/Dense> <cmath> <vector>)

foreach(lecture IN LISTS WORKBOOK_LECTURES)
  add_library(worked_examples_objects_${lecture} OBJECT EXCLUDE_FROM_ALL ${lecture}/worked_examples.cpp)
  target_link_libraries(worked_examples_objects_${lecture} PRIVATE rigid_contracts workbook_printed)
  target_precompile_headers(worked_examples_objects_${lecture} REUSE_FROM workbook_printed)

  # Without rigid::rigid, so that nothing is left for the reference implementation to fill in.
  add_executable(worked_examples_of_the_student_${lecture} EXCLUDE_FROM_ALL
    support/not_started.cpp $<TARGET_OBJECTS:exercises_of_the_student> $<TARGET_OBJECTS:worked_examples_objects_${lecture}>)
  target_link_libraries(worked_examples_of_the_student_${lecture} PRIVATE rigid_contracts workbook_printed workbook_doctest_main)

  add_library(figures_objects_${lecture} OBJECT EXCLUDE_FROM_ALL ${lecture}/figures.cpp)
  target_link_libraries(figures_objects_${lecture} PRIVATE rigid_contracts workbook_figure)
  target_precompile_headers(figures_objects_${lecture} REUSE_FROM workbook_figure)
  add_executable(draw_of_the_student_${lecture} EXCLUDE_FROM_ALL
    $<TARGET_OBJECTS:exercises_of_the_student> $<TARGET_OBJECTS:figures_objects_${lecture}>)
  target_link_libraries(draw_of_the_student_${lecture} PRIVATE rigid_contracts workbook_figure)
endforeach()
