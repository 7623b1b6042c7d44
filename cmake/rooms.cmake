# Adds a library of all sources below the given folders. The folders are globbed at each build, so new files need not be
# listed. With AUTOREF_UNITY 28 sources at a time are compiled as one, which compiles their common headers and templates
# only once; names in unnamed namespaces must therefore be unique within a target. HEADERS is the library whose precompiled
# headers it uses (default: autoref_headers).
#   autoref_room(TARGET FOLDER ... [HEADERS LIBRARY])
function(autoref_room target)
  cmake_parse_arguments(PARSE_ARGV 1 with "" HEADERS "")
  set(patterns ${with_UNPARSED_ARGUMENTS})
  if(NOT with_HEADERS)
    set(with_HEADERS autoref_headers)
  endif()
  list(TRANSFORM patterns APPEND "/*.cpp")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${patterns})
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$|/templates/")
  add_library(${target} STATIC ${sources})
  target_precompile_headers(${target} REUSE_FROM ${with_HEADERS})
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${AUTOREF_UNITY} UNITY_BUILD_BATCH_SIZE 28)
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
