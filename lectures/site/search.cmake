# Writes SITE/search.js: the words of every paragraph of the site, with its title and address. A paragraph is what stands
# below a heading. A script, because a page that is opened as a file may load no other kind of data.
#   cmake -D site=… -P search.cmake
cmake_minimum_required(VERSION 3.25)

# Cuts every part of the text in VARIABLE from FIRST to LAST, both included.
function(cut variable first last)
  set(rest "${${variable}}")
  set(kept "")
  string(LENGTH "${last}" length)
  while(TRUE)
    string(FIND "${rest}" "${first}" start)
    if(start EQUAL -1)
      break()
    endif()
    string(SUBSTRING "${rest}" 0 ${start} before)
    string(SUBSTRING "${rest}" ${start} -1 rest)
    string(FIND "${rest}" "${last}" end)
    if(end EQUAL -1)
      message(FATAL_ERROR "${page}: “${last}” is missing after “${first}”.")
    endif()
    math(EXPR end "${end} + ${length}")
    string(SUBSTRING "${rest}" ${end} -1 rest)
    string(APPEND kept "${before} ")
  endwhile()
  set(${variable} "${kept}${rest}" PARENT_SCOPE)
endfunction()

# Formulas between FIRST and LAST in the text in VARIABLE as one would type them: ω × L.
set(signs
  "[ \t\r\n]+= " "\\\\[,;:!>]=" "\\\\\\\\= " "\\\\(begin|end){[a-z*]*}=" "&amp.=" ".[0-9]+pt.="
  "\\\\ratein *{([^{}]*)}{\\\\([a-z]*)frame}=(d\\1/dt)_\\2"
  "frac *{([^{}]*[-+][^{}]*)}{=frac{(\\1)}{"
  "\\\\[td]?frac *{([^{}]*)}{([^{}]*)}=\\1/\\2" "\\\\[td]?frac *([0-9])([0-9])=\\1/\\2"
  "\\\\(boldsymbol|vec|unit|mat|hat|tilde|bar|dot|ddot|mathrm|mathsf|text|operatorname|mathcal|[bB]igg?[lr]?|left|right|quad|qquad|displaystyle)([^a-z])=\\2"
  "\\\\times=×" "\\\\cdots?=·" "\\\\approx=≈" "\\\\leq?([^f])=≤\\1" "\\\\geq?([^a-z])=≥\\1" "\\\\infty=∞" "\\\\sqrt=√"
  "\\\\(var)?theta=θ" "\\\\(var)?phi=φ" "\\\\psi=ψ" "\\\\omega=ω" "\\\\Omega=Ω" "\\\\alpha=α" "\\\\beta=β"
  "\\\\gamma=γ" "\\\\Gamma=Γ" "\\\\delta=δ" "\\\\Delta=Δ" "\\\\(var)?epsilon=ε" "\\\\lambda=λ" "\\\\mu=μ" "\\\\nu=ν" "\\\\pi=π"
  "\\\\rho=ρ" "\\\\sigma=σ" "\\\\tau=τ" "\\\\chi=χ" "\\\\Theta=Θ" "\\\\Phi=Φ" "\\\\pm=±" "\\\\to=→" "\\\\int=∫" "\\\\oint=∮" "\\\\ell=ℓ" "\\\\sum=∑"
  "\\\\zeta=ζ" "\\\\eta=η" "\\\\xi=ξ" "\\\\kappa=κ" "\\\\Pi=Π" "\\\\partial=∂" "\\\\nabla=∇" "\\\\dots=…" "\\\\propto=∝" "\\\\simeq=≃"
  "\\\\Longrightarrow=⟹" "\\\\mapsto=↦" "\\\\mp=∓" "\\\\gg=≫" "\\\\ll([^a-z])=≪\\1" "\\\\neq?([^a-z])=≠\\1" "\\\\langle=⟨" "\\\\rangle=⟩" "\\\\parallel=∥"
  "\\\\Inertia=I" "\\\\One=1" "\\\\dd=d" "\\\\degree=°" "_1=₁" "_2=₂" "_3=₃" "\\^2=²"
  "\\\\[td]?frac=" "\\\\([a-z]+)=\\1" "[{}\\\\]=" "- =−" " +([.,_^])=\\1" "/d t=/dt" "\\(d ([A-Z])=(d\\1" "∂ =∂")
function(write_formulas variable first last)
  set(rest "${${variable}}")
  set(kept "")
  while(TRUE)
    string(FIND "${rest}" "${first}" start)
    if(start EQUAL -1)
      break()
    endif()
    string(SUBSTRING "${rest}" 0 ${start} before)
    math(EXPR start "${start} + 2")
    string(SUBSTRING "${rest}" ${start} -1 rest)
    string(FIND "${rest}" "${last}" end)
    string(SUBSTRING "${rest}" 0 ${end} formula)
    math(EXPR end "${end} + 2")
    string(SUBSTRING "${rest}" ${end} -1 rest)
    foreach(sign IN LISTS signs)
      string(REGEX MATCH "^(.*)=([^=]*)$" sign "${sign}")
      string(REGEX REPLACE "${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}" formula "${formula}")
    endforeach()
    string(APPEND kept "${before}${formula}")
  endwhile()
  set(${variable} "${kept}${rest}" PARENT_SCOPE)
endfunction()

# What a reader sees of some HTML, in a JavaScript string.
function(plain variable html)
  string(REGEX REPLACE "<[^>]*>" " " text "${html}")
  foreach(pair "&lt=<" "&gt=>" "&quot=\"" "&#39='" "&nbsp= " "&ndash=–" "&amp=&")
    string(REGEX MATCH "^([^=]*)=(.*)$" pair "${pair}")
    string(REPLACE "${CMAKE_MATCH_1};" "${CMAKE_MATCH_2}" text "${text}")
  endforeach()
  string(REGEX REPLACE "[ \t\r\n]+" " " text "${text}")
  string(REPLACE "\\" "\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" text "${text}")
  string(STRIP "${text}" text)
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

set(paragraphs)
file(GLOB pages RELATIVE ${site} ${site}/*.html)
list(FILTER pages EXCLUDE REGEX "^(book|graph_legend)\\.html$")
foreach(page IN LISTS pages)
  file(READ ${site}/${page} html)
  string(FIND "${html}" "<div class=\"contents\">" start)
  string(SUBSTRING "${html}" ${start} -1 text)
  foreach(part "div class=\"fragment\"=/div><!-- fragment --" "div class=\"toc\"=/div" "svg =/svg" "script=/script"
               "div class=\"neighbours\"=/div" "div class=\"exercise-table\"=/div" "table class=\"markdownTable\"=/table")
    string(REGEX MATCH "^(.*)=([^=]*)$" part "${part}")
    cut(text "<${CMAKE_MATCH_1}" "<${CMAKE_MATCH_2}>")
  endforeach()
  write_formulas(text "\\(" "\\)")
  write_formulas(text "\\[" "\\]")
  string(REGEX MATCH "<title>([^<]*)" title "${html}")
  string(REPLACE " – Rigid Body Workbook" "" title "${CMAKE_MATCH_1}")
  plain(page_title "${title}")
  # How to check an exercise is the same for all, and its derivation is the answer.
  string(FIND "${text}" "<a class=\"anchor\" id=\"exercise_" end)
  if(NOT end EQUAL -1)
    string(SUBSTRING "${text}" 0 ${end} text)
  endif()
  # The part before the first heading belongs to the page as a whole.
  set(anchor)
  set(title "${page_title}")
  set(heading "<a class=\"anchor\" id=\"")
  while(TRUE)
    string(FIND "${text}" "${heading}" next)
    if(next EQUAL -1)
      set(body "${text}")
    else()
      string(SUBSTRING "${text}" 0 ${next} body)
    endif()
    plain(words "${body}")
    if(words)
      string(APPEND paragraphs "[\"${page}${anchor}\",\"${page_title}\",\"${title}\",\"${words}\"],\n")
    endif()
    if(next EQUAL -1)
      break()
    endif()
    string(SUBSTRING "${text}" ${next} -1 text)
    string(REGEX MATCH "^<a class=\"anchor\" id=\"([^\"]*)\"></a>([^<]*)(</h[1-6]>)?" start "${text}")
    string(LENGTH "${start}" length)
    string(SUBSTRING "${text}" ${length} -1 text)
    if(CMAKE_MATCH_3)
      set(anchor "#${CMAKE_MATCH_1}")
      plain(title "${CMAKE_MATCH_2}")
    endif()
  endwhile()
endforeach()
file(WRITE ${site}/search.js "const paragraphs = [\n${paragraphs}];\n")
