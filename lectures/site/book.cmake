# Prints the notes as one PDF: symbols, lectures with their exercises, answers, references, index. book.js puts the pages together
# in the browser that prints them, because only a browser knows their structure.
#   cmake -D site=… -D source=… -D output=… -D lectures=… -D browser=… -D book=… -P book.cmake
# A browser numbers pages but cannot say elsewhere where a heading landed. So the book is printed twice; the first PDF tells.
cmake_minimum_required(VERSION 3.25)

set(chapters "")
# The text of a page of the site as a part of the book, without what only a screen needs.
function(add_page page kind)
  file(READ ${site}/${page}.html html)
  string(REGEX MATCH "<title>([^<]*) – Rigid" title "${html}")
  set(title "${CMAKE_MATCH_1}")
  string(FIND "${html}" "<div class=\"textblock\">" start)
  string(FIND "${html}" "</div><!-- contents -->" end)
  math(EXPR length "${end} - ${start}")
  string(SUBSTRING "${html}" ${start} ${length} html)
  # Links between pages become links within the book; those to pages that it does not have go.
  string(REGEX REPLACE "href=\"(slides|errata|index|exercises|practice|marks|authors)\\.html[^\"]*\"" "" html "${html}")
  string(REGEX REPLACE "href=\"[a-z0-9_]+\\.html#" "href=\"#" html "${html}")
  string(REGEX REPLACE "href=\"([A-Za-z0-9_]+)\\.html\"" "href=\"#\\1\"" html "${html}")
  # Of an exercise, the figure of its section, how to check it and its derivation are left out.
  if(kind STREQUAL "exercise")
    string(REGEX REPLACE "(<figure>|<h1><a class=\"anchor\" id=\"exercise_).*" "" html "${html}")
    string(APPEND html "</div>")
  endif()
  set(chapters "${chapters}<section class=\"${kind}\" id=\"${page}\" data-title=\"${title}\">${html}</section>\n" PARENT_SCOPE)
endfunction()

add_page(notation chapter)
file(READ ${output}/sequence.txt sequence)
foreach(page IN LISTS sequence)
  if(page IN_LIST lectures)
    add_page(lecture_${page} chapter)
    file(READ ${source}/lectures/${page}/card.json card)
    string(JSON count LENGTH "${card}" exercises)
    math(EXPR last "${count} - 1")
    foreach(index RANGE ${last})
      string(JSON name GET "${card}" exercises ${index} name)
      add_page(exercise_${name} exercise)
    endforeach()
  else()
    add_page(lecture_${page} part)
  endif()
endforeach()
add_page(references chapter)
add_page(formulas chapter)

# The head of any page has what formulas and looks need.
file(READ ${site}/notation.html head)
string(FIND "${head}" "</head>" end)
string(SUBSTRING "${head}" 0 ${end} head)
string(REGEX REPLACE "<script src=\"[^<]*</script>" "" head "${head}")
string(REGEX REPLACE "<title>[^<]*" "<title>Rigid Body Workbook" head "${head}")
file(READ ${CMAKE_CURRENT_LIST_DIR}/book.css style)
file(READ ${CMAKE_CURRENT_LIST_DIR}/book.js script)
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/index_terms.txt terms ENCODING UTF-8)
list(JOIN terms "\", \"" terms)
file(READ ${output}/parts/edition.md edition)

# Prints the book; PAGES is the place of every heading, as a JavaScript object.
function(print_book pages)
  file(WRITE ${site}/book.html "${head}<style>${style}</style></head><body><div class=\"contents\"><div id=\"title\"><h1>Rigid Body Workbook</h1>
<p>Rotating bodies, derived and computed</p><p>The developers of the Rigid Body Workbook<br>${edition}<br>MIT licence</p></div>
${chapters}</div><script>const pages = ${pages}, terms = [\"${terms}\"];\n${script}</script></body></html>\n")
  file(REMOVE ${book})
  execute_process(
    COMMAND ${browser} --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --user-data-dir=${book}.profile
            --no-pdf-header-footer --generate-pdf-document-outline --virtual-time-budget=600000 --timeout=600000
            --print-to-pdf=${book} file://${site}/book.html
    ERROR_VARIABLE said OUTPUT_QUIET)
  file(REMOVE_RECURSE ${book}.profile)
  file(REMOVE ${site}/book.html)
  if(NOT EXISTS ${book})
    message(FATAL_ERROR "The browser ${browser} did not print the book:\n${said}")
  endif()
endfunction()

print_book("{}")
# The objects of a PDF stand in its file in the order of the pages; destinations are "/name [OBJECT 0 R /XYZ …".
file(STRINGS ${book} lines REGEX "^[0-9]+ 0 obj|^<</Type /Page$|/XYZ")
set(page 0)
set(pages "")
foreach(line IN LISTS lines)
  if(line MATCHES "^([0-9]+) 0 obj")
    set(object ${CMAKE_MATCH_1})
  elseif(line STREQUAL "<</Type /Page")
    math(EXPR page "${page} + 1")
    set(page_of_${object} ${page})
  elseif(line MATCHES "/([A-Za-z0-9_]+) .([0-9]+) 0 R /XYZ" AND NOT CMAKE_MATCH_1 STREQUAL "Dest")
    string(APPEND pages "${CMAKE_MATCH_1}:${page_of_${CMAKE_MATCH_2}},")
  endif()
endforeach()
if(NOT pages MATCHES "lecture_")
  message(FATAL_ERROR "The printed book has no page for a lecture: this browser writes PDF in another way.")
endif()
print_book("{${pages}}")
# The first page of the notes leads to it.
file(CREATE_LINK ${book} ${site}/workbook.pdf COPY_ON_ERROR)
file(READ ${site}/index.html html)
string(REGEX REPLACE "<span id=\"book\">[^\n]*</span>" "<span id=\"book\"><a href=\"workbook.pdf\">workbook.pdf</a>, ${page} pages</span>" html "${html}")
file(WRITE ${site}/index.html "${html}")
message(STATUS "${book}: ${page} pages")
