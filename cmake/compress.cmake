# Compresses a file the way Debian compresses documentation, at configure time. The output contains neither time nor
# name.
#   autoref_compress(FILE OUTPUT)
function(autoref_compress file output)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  execute_process(COMMAND gzip -9nc ${file} OUTPUT_FILE ${output} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
