# Worked examples and figures with the reference implementation: what the notes show.
foreach(lecture IN LISTS WORKBOOK_LECTURES)
  # Worked examples: a program of doctest cases; what it prints is quoted in the notes.
  add_executable(worked_examples_${lecture} EXCLUDE_FROM_ALL $<TARGET_OBJECTS:worked_examples_objects_${lecture}>)
  target_link_libraries(worked_examples_${lecture} PRIVATE rigid::rigid workbook_printed workbook_doctest_main)
  set(printed ${CMAKE_BINARY_DIR}/printed/${lecture}.txt)
  add_custom_command(
    OUTPUT ${printed}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/printed
    COMMAND ${CMAKE_COMMAND} -E rm -f ${printed}
    COMMAND ${CMAKE_COMMAND} -E env WORKBOOK_PRINTED=${printed} $<TARGET_FILE:worked_examples_${lecture}> --minimal=true
    DEPENDS worked_examples_${lecture}
    COMMENT "Numbers printed by the worked examples of ${lecture}"
    VERBATIM)
  add_custom_target(printed_${lecture} DEPENDS ${printed})

  add_executable(draw_${lecture} EXCLUDE_FROM_ALL $<TARGET_OBJECTS:figures_objects_${lecture}>)
  target_link_libraries(draw_${lecture} PRIVATE rigid::rigid workbook_figure)
  set(figures_drawn ${CMAKE_BINARY_DIR}/figures/${lecture}/drawn)
  add_custom_command(
    OUTPUT ${figures_drawn}
    COMMAND draw_${lecture} ${CMAKE_BINARY_DIR}/figures/${lecture}
    COMMAND ${CMAKE_COMMAND} -E touch ${figures_drawn}
    DEPENDS draw_${lecture}
    COMMENT "Figures of ${lecture}"
    VERBATIM)
  add_custom_target(figures_${lecture} DEPENDS ${figures_drawn})
  list(APPEND all_worked_examples worked_examples_${lecture})
  list(APPEND all_printed printed_${lecture})
  list(APPEND all_figures figures_${lecture})
endforeach()
add_custom_target(worked_examples DEPENDS ${all_worked_examples})
add_custom_target(figures DEPENDS ${all_figures})

# All that `checker handout` copies from the build.
add_custom_target(handed_out DEPENDS reference_results ${all_printed} ${all_figures})
