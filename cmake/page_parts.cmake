# Generates the source for runner/view/page_parts.hpp:
#   cmake -DFOLDER=runner/view/page "-DSCRIPTS=a.js b.js" -DOUTPUT=... -P page_parts.cmake
# SCRIPTS are concatenated in this order.
function(append_part name)
  set(literals "")
  foreach(file IN LISTS ARGN)
    file(READ ${FOLDER}/${file} content)
    string(APPEND literals "\n      R\"page(${content})page\"")
  endforeach()
  set(source "${source}std::string_view page_${name}() {\n  return ${literals};\n}\n\n" PARENT_SCOPE)
endfunction()

string(REPLACE " " ";" scripts "${SCRIPTS}")
set(source "#include \"runner/view/page_parts.hpp\"\n\nnamespace autoref::runner {\n\n")
append_part(frame page.html)
append_part(style style.css)
append_part(script ${scripts})
string(APPEND source "}  // namespace autoref::runner\n")
file(WRITE ${OUTPUT} "${source}")
