cmake_minimum_required(VERSION 3.25)
# cmake -DROOT=… -P Format.cmake: every C++ file is as clang-format 14 leaves it. Other versions format
# otherwise, so with them, or without any, it says "skipped" (the test's SKIP_REGULAR_EXPRESSION).
find_program(CLANG_FORMAT NAMES clang-format-14 clang-format)
if(NOT CLANG_FORMAT)
  message(STATUS "skipped: no clang-format")
  return()
endif()
execute_process(COMMAND ${CLANG_FORMAT} --version OUTPUT_VARIABLE version)
if(NOT version MATCHES "version 14\\.")
  message(STATUS "skipped: ${version}")
  return()
endif()
file(GLOB_RECURSE files ${ROOT}/framework/*.h ${ROOT}/framework/*.cpp ${ROOT}/assignments/*.h
     ${ROOT}/assignments/*.cpp ${ROOT}/solutions/*.cpp ${ROOT}/autograder/*.h ${ROOT}/autograder/*.cpp
     ${ROOT}/docs/*.cpp)
execute_process(COMMAND ${CLANG_FORMAT} --dry-run -Werror ${files} ERROR_VARIABLE complaints
                RESULT_VARIABLE result)
if(result)
  string(REGEX MATCHALL "[^\n]*: error: [^\n]*" lines "${complaints}")
  list(TRANSFORM lines REPLACE ":[0-9]+:[0-9]+: error: .*" "")
  list(REMOVE_DUPLICATES lines)
  list(JOIN lines "\n  " lines)
  message(FATAL_ERROR "run clang-format -i on\n  ${lines}")
endif()
