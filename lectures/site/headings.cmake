# Corrects what Doxygen makes in its own way: the first page would be named twice in its title, lists of \xrefitem name
# the page on which an item stands, where a lecture of several pages has all its items on the last one, and functions lead
# to a page that repeats every contract, where each has its own page as an exercise. That page and other lists of Doxygen go.
#   cmake -D site=… -P headings.cmake
cmake_minimum_required(VERSION 3.25)

function(correct page wrong right)
  file(READ ${site}/${page}.html html)
  if(NOT html MATCHES "${wrong}")
    message(FATAL_ERROR "${page}.html has no “${wrong}”: this Doxygen heads its pages in another way.")
  endif()
  string(REGEX REPLACE "${wrong}" "${right}" html "${html}")
  file(WRITE ${site}/${page}.html "${html}")
endfunction()

correct(index "<title>Rigid Body Workbook – Rigid Body Workbook" "<title>Rigid Body Workbook")
foreach(list slides errata)
  correct(${list} "<dt>Page <a [^>]*>([^<:]*)[^<]*</a> *</dt>" "<dt>\\1</dt>")
endforeach()

file(GLOB lists ${site}/annotated.html ${site}/classes.html ${site}/dir_*.html ${site}/functions*.html ${site}/namespace*.html
  ${site}/pages.html ${site}/struct*.html ${site}/*.png ${site}/doxygen.svg ${site}/dynsections.js ${site}/jquery.js ${site}/tabs.css)
file(REMOVE ${lists})
file(GLOB pages ${site}/*.html)
foreach(page IN LISTS pages)
  file(READ ${page} html)
  string(REGEX REPLACE "href=\"namespacerigid\\.html#[a-z0-9]+\"([^>]*)>(rigid::)?([A-Za-z0-9_]+)" "href=\"exercise_\\3.html\"\\1>\\3" html "${html}")
  # Coloured words end with a space, which is one too many before a full stop.
  string(REGEX REPLACE " </span>([.,])" "</span>\\1" html "${html}")
  file(WRITE ${page} "${html}")
endforeach()
