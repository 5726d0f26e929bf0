# A script of live figures as the pages load it.
#   cmake -D scene=FOLDER -D output=FILE -P live.cmake
#   cmake -D lecture=FOLDER -D output=FILE -P live.cmake
if(scene)
  # With its shaders, and what surrounds the pictures of a figure.
  foreach(part vert frag html js)
    file(READ ${scene}/scene.${part} ${part})
  endforeach()
  file(WRITE ${output} "const shaders = { vert: `${vert}`, frag: `${frag}` }, form = `${html}`;\n${js}")
  return()
endif()
# Of a lecture what its figures say and offer, live.json, before live.js.
file(READ ${lecture}/live.json texts)
file(READ ${lecture}/live.js script)
# Measured data, where the figures have some.
string(JSON table ERROR_VARIABLE none GET "${texts}" table)
if(NOT none)
  file(READ ${lecture}/${table} rows)
  set(script "const table = `${rows}`;\n${script}")
endif()
file(WRITE ${output} "Object.assign(texts, ${texts});\n${script}")
