# Corrects what Doxygen heads in its own way: the first page would be named twice in its title, and lists of \xrefitem name
# the page on which an item stands, where a lecture of several pages has all its items on the last one.
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
