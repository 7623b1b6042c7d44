# Generates the source of autoref::io::build_id() at build time:
#   cmake -DSOURCE_DIR=... "-DROOMS=soccer sim ..." -DVERSION=... -DOUTPUT=... -P build_id.cmake
# The file is left alone if its content would not change.
set(sources CMakeLists.txt)
string(REPLACE " " ";" rooms "${ROOMS}")
foreach(room IN LISTS rooms)
  file(GLOB_RECURSE found RELATIVE ${SOURCE_DIR}
       ${SOURCE_DIR}/${room}/*.hpp ${SOURCE_DIR}/${room}/*.cpp ${SOURCE_DIR}/${room}/*.def ${SOURCE_DIR}/${room}/*.proto ${SOURCE_DIR}/${room}/CMakeLists.txt)
  list(APPEND sources ${found})
endforeach()
list(SORT sources)
set(all "")
foreach(source IN LISTS sources)
  file(SHA256 ${SOURCE_DIR}/${source} hash)
  string(APPEND all "${source} ${hash}\n")
endforeach()
string(SHA256 hash "${all}")
string(SUBSTRING ${hash} 0 12 hash)
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [=[
#include "io/build_id.hpp"

namespace autoref::io {

std::string_view build_id() { return "@VERSION@-@hash@"; }

}  // namespace autoref::io
]=] @ONLY)
