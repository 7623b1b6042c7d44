# Generates the source for view/page_parts.hpp:
#   cmake -DFOLDER=view/page "-DSCRIPTS=a.js b.js" "-DLIVE_SCRIPTS=c.js" -DOUTPUT=... -P page_parts.cmake
# SCRIPTS and LIVE_SCRIPTS are concatenated in this order, when the program first needs them: compilers need not support
# literals of more than 65536 characters.
function(append_part name)
  set(literals "")
  foreach(file IN LISTS ARGN)
    file(READ ${FOLDER}/${file} content)
    string(APPEND literals "\n      R\"page(${content})page\",")
  endforeach()
  set(source "${source}std::string_view page_${name}() {\n  static const std::string text = joined({${literals}});\n  return text;\n}\n\n" PARENT_SCOPE)
endfunction()

string(REPLACE " " ";" scripts "${SCRIPTS}")
string(REPLACE " " ";" live_scripts "${LIVE_SCRIPTS}")
set(source "#include \"view/page_parts.hpp\"\n\n#include <initializer_list>\n#include <string>\n\nnamespace autoref::view {\n")
string(APPEND source "namespace {\n\nstd::string joined(std::initializer_list<std::string_view> files) {\n  std::string text;\n"
                     "  for (const std::string_view file : files) text.append(file);\n  return text;\n}\n\n}  // namespace\n\n")
append_part(frame page.html)
append_part(style style.css)
append_part(script ${scripts})
append_part(start start.js)
append_part(live_style live.css)
append_part(bracket_style bracket.css)
append_part(live_script ${live_scripts})
append_part(run run.html)
append_part(run_style run.css)
append_part(run_script live_connection.js run_main.js)
string(APPEND source "}  // namespace autoref::view\n")
file(WRITE ${OUTPUT} "${source}")
