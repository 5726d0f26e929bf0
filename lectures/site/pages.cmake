# Writes what follows from the cards: the list of lectures, a page for each exercise, the parts of pages that notes.md
# quotes, and the header of every page with the navigation.
#   cmake -D source=… -D solutions=ON|OFF -D figures=… -D output=… -D lectures=… -P pages.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${output})
file(READ ${CMAKE_CURRENT_LIST_DIR}/header.html header)

# VARIABLE = the value of a key of the card, or "" without it.
macro(read_card variable)
  string(JSON ${variable} ERROR_VARIABLE problem GET "${card}" ${ARGN})
  if(problem)
    set(${variable} "")
  endif()
endmacro()

# VARIABLE = "03 The inertia tensor" for a lecture.
function(title_of variable lecture)
  file(READ ${source}/lectures/${lecture}/card.json card)
  read_card(title title)
  string(SUBSTRING ${lecture} 0 2 number)
  set(${variable} "${number} ${title}" PARENT_SCOPE)
endfunction()

# The pages of the lectures in their order: ID and title. Besides its own, a lecture has one for each line
# "\page lecture_ID TITLE" of its notes.md.
set(sequence)
foreach(lecture IN LISTS lectures)
  title_of(title_of_${lecture} ${lecture})
  set(parts_of_${lecture})
  list(APPEND sequence ${lecture})
  file(STRINGS ${source}/lectures/${lecture}/notes.md parts REGEX "^.page lecture_")
  foreach(part IN LISTS parts)
    string(REGEX MATCH "^.page lecture_([a-z0-9_]+) (.+)$" part "${part}")
    set(title_of_${CMAKE_MATCH_1} "${CMAKE_MATCH_2}")
    list(APPEND parts_of_${lecture} ${CMAKE_MATCH_1})
    list(APPEND sequence ${CMAKE_MATCH_1})
  endforeach()
endforeach()
set(before)
foreach(page IN LISTS sequence)
  if(before)
    string(APPEND links_of_${page} "\\ref lecture_${before} \"← ${title_of_${before}}\" ")
    string(APPEND links_of_${before} "\\ref lecture_${page} \"${title_of_${page}} →\"")
  endif()
  set(before ${page})
endforeach()
foreach(page IN LISTS sequence)
  file(WRITE ${output}/parts/${page}.links.md
    "<div class=\"neighbours\" role=\"navigation\" aria-label=\"Lectures\">${links_of_${page}}</div>\n")
endforeach()

# The exercises in the same order, with what follows and precedes each.
set(before)
foreach(lecture IN LISTS lectures)
  file(READ ${source}/lectures/${lecture}/card.json card)
  string(JSON count LENGTH "${card}" exercises)
  math(EXPR last "${count} - 1")
  foreach(index RANGE ${last})
    read_card(name exercises ${index} name)
    if(before)
      string(APPEND links_of_exercise_${name} "\\ref exercise_${before} \"← ${before}\" ")
      string(APPEND links_of_exercise_${before} "\\ref exercise_${name} \"${name} →\"")
    endif()
    set(before ${name})
  endforeach()
endforeach()

set(edition)       # what the head of every page says of them
set(course)        # the list of the first page
set(all_exercises) # the page of all exercises
set(navigation)
set(exercises_js)
foreach(lecture IN LISTS lectures)
  set(title "${title_of_${lecture}}")
  file(READ ${source}/lectures/${lecture}/card.json card)
  read_card(summary summary)
  read_card(contract contract)
  file(READ ${source}/include/rigid/${contract}.hpp declarations)
  file(READ ${source}/lectures/${lecture}/notes.md notes)
  string(JSON count LENGTH "${card}" exercises)
  math(EXPR last "${count} - 1")

  set(names)
  set(list)
  foreach(index RANGE ${last})
    read_card(name exercises ${index} name)
    read_card(worth exercises ${index} points)
    read_card(anchor exercises ${index} notes)
    list(APPEND names ${name})
    string(JSON difficulty ERROR_VARIABLE is_left_out GET "${card}" exercises ${index} difficulty)
    if(is_left_out)
      set(difficulty 1)
      set(minutes 10)
    else()
      read_card(minutes exercises ${index} minutes)
    endif()
    string(REPEAT "★" ${difficulty} stars)
    set(effort "Exercise, difficulty ${difficulty} of 3, about ${minutes} minutes. ")
    set(mark "${stars}, ${minutes} min, ")
    string(JSON ignored ERROR_VARIABLE is_exercise GET "${card}" exercises ${index} problem)
    if(NOT is_exercise)
      set(effort "Problem, difficulty ${difficulty} of 3, about ${minutes} minutes: the formula is yours to find. ")
      set(mark "Problem ${mark}")
    endif()
    # From the start of a line that holds NAME( and is no comment, to the semicolon.
    if(NOT declarations MATCHES "\n([^/\n][^\n]*[ &]${name}\\([^;]*;)")
      message(FATAL_ERROR "include/rigid/${contract}.hpp does not declare ${name}, though the card of ${lecture} lists it.")
    endif()
    set(declaration "${CMAKE_MATCH_1}")
    # The first sentence of its contract, a paragraph of its own, is the title.
    string(FIND "${declarations}" "${declaration}" end)
    string(SUBSTRING "${declarations}" 0 ${end} contract_text)
    string(FIND "${contract_text}" "\n\n" start REVERSE)
    string(SUBSTRING "${contract_text}" ${start} -1 contract_text)
    if(NOT contract_text MATCHES "^\n\n/// (([^\n]|\n/// )*[^\n])\n///\n")
      message(FATAL_ERROR "include/rigid/${contract}.hpp: the contract of ${name} begins with no paragraph of its own.")
    endif()
    string(REPLACE "\n///" "" phrase "${CMAKE_MATCH_1}")
    string(REGEX REPLACE "\\.$" "" phrase "${phrase}")
    set(points "points")
    if(worth EQUAL 1)
      set(points "point")
    endif()
    # The first figure of the section to read, outside of what is folded.
    string(FIND "${notes}" "{#${anchor}}\n" start)
    string(SUBSTRING "${notes}" ${start} -1 section)
    string(REGEX REPLACE "(\n##|\\\\(folded|solved|answer)).*" "" section "${section}")
    set(figure)
    if(section MATCHES "\\\\figure{([^}]+)}\n([^\\]+)")
      set(figure "\n\\figure{${CMAKE_MATCH_1}}\n${CMAKE_MATCH_2}\\caption\nFrom \\ref ${anchor}.\n\\endfigure\n")
    endif()
    string(APPEND list "- \\ref exercise_${name} \"${phrase}\"<br>`${name}` ${mark}${worth} ${points}\n")
    string(CONFIGURE [[# @phrase@ {#exercise_@name@}

`@name@`. @effort@Lecture \ref lecture_@lecture@ "@title@", points: @worth@; to read first: \ref @anchor@.

```{.cpp}
@declaration@
```

\copydetails rigid::@name@
@figure@
## Check yours {#exercise_@name@_check}

Write it in `lectures/@lecture@/exercises/@name@.cpp`, then

```
./checker/run check @name@
```

When you are stuck, `./checker/run hint @name@` gives a hint, and a further one each time you ask.
]] text @ONLY)
    # Only instructors' notes have it: what students get holds no solutions.
    if(solutions AND EXISTS ${source}/solutions/${lecture}/derivations/${name}.md)
      file(READ ${source}/solutions/${lecture}/derivations/${name}.md derivation)
      set(heading "Derivation")
      if(is_exercise)
        set(heading "Another route")
      endif()
      string(APPEND text "\n## ${heading} {#exercise_${name}_derivation}\n\n\\answer\n${derivation}\n\\endanswer\n")
      set(edition "<span id=\"edition\">Instructor's edition</span>")
    endif()
    string(APPEND text "\n<div class=\"neighbours\" role=\"navigation\" aria-label=\"Exercises\">${links_of_exercise_${name}}</div>\n")
    file(WRITE ${output}/exercises/${name}.md "${text}")
  endforeach()

  set(foundations)
  string(JSON count LENGTH "${card}" builds_on)
  if(count)
    math(EXPR last "${count} - 1")
    foreach(index RANGE ${last})
      read_card(earlier builds_on ${index})
      list(APPEND foundations "\\ref lecture_${earlier} \"${title_of_${earlier}}\"")
    endforeach()
    list(JOIN foundations ", " foundations)
    set(foundations "Builds on ${foundations}. ")
  endif()
  set(parts)
  foreach(part IN LISTS parts_of_${lecture})
    string(REGEX REPLACE "^.*: " "" part_title "${title_of_${part}}")
    string(APPEND parts "<li><a href=\"lecture_${part}.html\">${part_title}</a></li>")
  endforeach()
  if(parts)
    set(parts "<ul>${parts}</ul>")
  endif()

  file(WRITE ${output}/parts/${lecture}.card.md
    "<div class=\"lecture-card\">${foundations}Its functions: `rigid/${contract}.hpp`.</div>\n")
  file(WRITE ${output}/parts/${lecture}.exercises.md "<div class=\"exercise-table\">\n\n${list}\n</div>\n")
  list(LENGTH names count)
  # A minute for 120 words and half of one for each formula of a line of its own, to five minutes.
  string(REGEX MATCHALL "[A-Za-z]+[ ,.:\n]" words "${notes}")
  string(REGEX MATCHALL "f\\[" formulas "${notes}")
  list(LENGTH words words)
  list(LENGTH formulas formulas)
  math(EXPR minutes "(${words} / 120 + ${formulas} / 2 + 2) / 5 * 5")
  read_card(picture picture)
  if(picture)
    # On the first page it is small: without texts, in whole pixels, and with names of its own beside the figure of that page.
    file(READ ${figures}/${lecture}/${picture}.svg picture)
    string(REGEX REPLACE "<(text|metadata)>[^\n]*</(text|metadata)>" "" picture "${picture}")
    string(REGEX REPLACE "([0-9][0-9])\\.[0-9]+" "\\1" picture "${picture}")
    string(REGEX REPLACE "(id=['\"]|href=['\"]#|url\\(#)" "\\1small-" picture "${picture}")
  endif()
  string(APPEND course "<div class=\"lecture\"><div class=\"picture\">${picture}</div><p><a href=\"lecture_${lecture}.html\">${title}</a><br>${summary} "
    "<span class=\"effort\">${minutes} minutes to read, ${count} exercises</span></p></div>\n")
  # Not a heading of Markdown, whose anchor would need a name.
  string(APPEND all_exercises "\n<h2>${title}</h2>\n\n${list}")
  string(APPEND navigation "<li><a href=\"lecture_${lecture}.html\">${title}</a>${parts}"
    "<details><summary aria-label=\"${count} exercises of ${title}\">${count} exercises</summary></details></li>\n")
  list(JOIN names "\",\"" names)
  string(APPEND exercises_js "[\"${names}\"],\n")
endforeach()

file(WRITE ${output}/parts/course.html "<div class=\"course\">\n${course}</div>\n")
string(TIMESTAMP today "%d %B %Y" UTC)
file(WRITE ${output}/parts/edition.md "Edition of ${today}")
file(WRITE ${output}/exercises.md "# Exercises {#exercises}

<div class=\"exercise-table\">

One function each, in the order of the course. A page shows what the function means, its units and its errors, and where the
notes explain it.
${all_exercises}
</div>
")
string(REPLACE "@navigation@" "${navigation}" header "${header}")
string(REPLACE "@edition@" "${edition}" header "${header}")
file(WRITE ${output}/header.html "${header}")
file(READ ${CMAKE_CURRENT_LIST_DIR}/course.js script)
file(WRITE ${output}/exercises.js "const exercises = [\n${exercises_js}];\n${script}")
file(WRITE ${output}/sequence.txt "${sequence}")
