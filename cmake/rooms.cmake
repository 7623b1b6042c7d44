# A library of all sources below the given folders of the current one. Lists are globbed anew at each build, so that a new
# file takes part without being named here.
#   autoref_room(TARGET FOLDER ...)
function(autoref_room target)
  set(patterns ${ARGN})
  list(TRANSFORM patterns APPEND "/*.cpp")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${patterns})
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  add_library(${target} STATIC ${sources})
  target_precompile_headers(${target} REUSE_FROM autoref_headers)
endfunction()
