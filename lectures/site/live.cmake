# The script of a lecture's live figures as the pages load it: what they say and offer, live.json, before live.js.
#   cmake -D lecture=FOLDER -D output=FILE -P live.cmake
file(READ ${lecture}/live.json texts)
file(READ ${lecture}/live.js script)
# Measured data, where the figures have some.
string(JSON table ERROR_VARIABLE none GET "${texts}" table)
if(NOT none)
  file(READ ${lecture}/${table} rows)
  set(script "const table = `${rows}`;\n${script}")
endif()
file(WRITE ${output} "Object.assign(texts, ${texts});\n${script}")
