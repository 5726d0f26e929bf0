# Draws the course map for a page: as SVG without the prologue of a file of its own, so that its links are links of the page.
execute_process(COMMAND ${dot} -Tsvg ${graph} OUTPUT_VARIABLE svg COMMAND_ERROR_IS_FATAL ANY)
string(FIND "${svg}" "<svg" start)
string(SUBSTRING "${svg}" ${start} -1 svg)
file(WRITE ${picture} "${svg}")
