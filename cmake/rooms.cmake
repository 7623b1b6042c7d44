# A library of all sources below the given folders of the current one. Lists are globbed anew at each build, so that a new
# file takes part without being named here. Twelve sources at a time are compiled as one (AUTOREF_UNITY), so that their common headers and
# templates are compiled once: names in unnamed namespaces are unique in a room.
#   autoref_room(TARGET FOLDER ...)
function(autoref_room target)
  set(patterns ${ARGN})
  list(TRANSFORM patterns APPEND "/*.cpp")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${patterns})
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  add_library(${target} STATIC ${sources})
  target_precompile_headers(${target} REUSE_FROM autoref_headers)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${AUTOREF_UNITY} UNITY_BUILD_BATCH_SIZE 12)
endfunction()
