# Doxygen writes a page for every folder of its input, to which nothing leads.
file(GLOB folder_pages ${site}/dir_*.html)
file(REMOVE ${folder_pages})
