# ctest reads this file when it starts (autoref_test_room in CMakeLists.txt), with these variables:
#   room       name and label of the tests
#   program    the room's test program
#   skippable  filter of the tests that may be skipped; each is an entry of its own, so that ctest can name it
#   left_out   filter of the tests that have an entry elsewhere
#   only_skippable   whether the others have entries elsewhere, too
#   longest_test_s   timeout
# It adds an entry for each suite of the program. Instances of a parameterised suite are one entry.
if(NOT EXISTS "${program}")
  add_test(${room}.is_not_built "${program}")
  set_tests_properties(${room}.is_not_built PROPERTIES LABELS ${room})
  return()
endif()

function(list_tests filter result)
  execute_process(COMMAND "${program}" --gtest_list_tests "--gtest_filter=${filter}" OUTPUT_VARIABLE listed
                  COMMAND_ERROR_IS_FATAL ANY)
  # Of a line such as "  Test/0  # GetParam() = [1; 2]" only the name counts.
  string(REGEX REPLACE "[ \t]+#[^\n]*" "" listed "${listed}")
  string(REGEX MATCHALL "[^\n]+" listed "${listed}")
  set(${result} "${listed}" PARENT_SCOPE)
endfunction()

set(lines "")
if(NOT only_skippable)
  list_tests("*-${skippable}:${left_out}" lines)
endif()
set(suites "")
foreach(line IN LISTS lines)
  if(line MATCHES "^([^ ]*/)?([A-Za-z0-9_]+)\\.$")
    list(APPEND suites ${CMAKE_MATCH_2})
  endif()
endforeach()
list(REMOVE_DUPLICATES suites)
foreach(suite IN LISTS suites)
  add_test(${room}.${suite} "${program}" --gtest_brief=1
           "--gtest_filter=${suite}.*:*/${suite}.*-${skippable}:${left_out}")
  set_tests_properties(${room}.${suite} PROPERTIES LABELS ${room} TIMEOUT ${longest_test_s} FAIL_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
endforeach()

list_tests("${skippable}" lines)
foreach(line IN LISTS lines)
  if(line MATCHES "^ +([^ ]+)$")
    set(name ${suite}${CMAKE_MATCH_1})
    add_test(${room}.${name} "${program}" --gtest_brief=1 "--gtest_filter=${name}")
    set_tests_properties(${room}.${name} PROPERTIES LABELS ${room} TIMEOUT ${longest_test_s} SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
  elseif(line MATCHES "^[^ ]+\\.$")
    set(suite ${line})
  endif()
endforeach()
