# Adds the library autoref_ROOM with all sources below the current folder. The folders are globbed at each build, so new
# files need not be listed. With AUTOREF_UNITY, 28 sources at a time are compiled as one, so their common headers and
# templates are compiled only once; names in unnamed namespaces must therefore be unique within a room. LESS_OPTIMISED
# is for rooms that do little work in a frame of a game: compiling them with less optimisation takes two thirds of the
# time.
#   autoref_room(ROOM [LESS_OPTIMISED])
function(autoref_room room)
  cmake_parse_arguments(PARSE_ARGV 1 with "LESS_OPTIMISED" "" "")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$|/templates/")
  add_library(autoref_${room} STATIC ${sources})
  set(headers autoref_headers)
  if(with_LESS_OPTIMISED)
    string(APPEND headers _less_optimised)
    target_compile_options(autoref_${room} PRIVATE ${AUTOREF_LESS_OPTIMISED})
  endif()
  target_precompile_headers(autoref_${room} REUSE_FROM ${headers})
  set_target_properties(autoref_${room} PROPERTIES UNITY_BUILD ${AUTOREF_UNITY} UNITY_BUILD_BATCH_SIZE 28)
endfunction()

# Adds a generated source to a room. It is compiled on its own, because clang-tidy does not check it.
#   autoref_generated(ROOM SOURCE)
function(autoref_generated room source)
  target_sources(autoref_${room} PRIVATE ${source})
  set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# Installs a room's library and headers, so that other projects can link it as autoref::ROOM (docs/packages.md).
#   autoref_export(ROOM)
function(autoref_export room)
  add_library(autoref::${room} ALIAS autoref_${room})
  set_target_properties(autoref_${room} PROPERTIES EXPORT_NAME ${room})
  install(TARGETS autoref_${room} EXPORT autoref ARCHIVE DESTINATION lib COMPONENT development
          INCLUDES DESTINATION include/autoref)
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} DESTINATION include/autoref COMPONENT development
          FILES_MATCHING PATTERN "*.hpp" PATTERN "*.def" PATTERN lab EXCLUDE PATTERN kinds EXCLUDE)
endfunction()
