# A copy of the workbook as students get it: what the reference implementation made comes as data.
foreach(lecture IN LISTS WORKBOOK_LECTURES)
  set(data ${CMAKE_CURRENT_SOURCE_DIR}/${lecture}/handed_out)
  set(results ${CMAKE_BINARY_DIR}/reference/${lecture}.json)
  add_custom_command(
    OUTPUT ${results}
    COMMAND ${CMAKE_COMMAND} -E copy ${data}/reference.json ${results}
    DEPENDS ${data}/reference.json
    COMMENT "Reference results of ${lecture}"
    VERBATIM)
  list(APPEND all_results ${results})

  set(printed ${CMAKE_BINARY_DIR}/printed/${lecture}.txt)
  add_custom_command(
    OUTPUT ${printed}
    COMMAND ${CMAKE_COMMAND} -E copy ${data}/printed.txt ${printed}
    DEPENDS ${data}/printed.txt
    COMMENT "Numbers printed by the worked examples of ${lecture}"
    VERBATIM)
  add_custom_target(printed_${lecture} DEPENDS ${printed})

  set(figures_drawn ${CMAKE_BINARY_DIR}/figures/${lecture}/drawn)
  add_custom_command(
    OUTPUT ${figures_drawn}
    COMMAND ${CMAKE_COMMAND} -E copy_directory ${data}/figures ${CMAKE_BINARY_DIR}/figures/${lecture}
    COMMAND ${CMAKE_COMMAND} -E touch ${figures_drawn}
    DEPENDS ${data}/figures
    COMMENT "Figures of ${lecture}"
    VERBATIM)
  add_custom_target(figures_${lecture} DEPENDS ${figures_drawn})
  list(APPEND all_figures figures_${lecture})
endforeach()
add_custom_target(reference_results ALL DEPENDS ${all_results})
add_custom_target(figures DEPENDS ${all_figures})
