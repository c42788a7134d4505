# What the CMake files share: compile flags, one library per framework layer, assignments found by
# scanning folders.

add_library(penumbra_flags INTERFACE)
target_include_directories(penumbra_flags INTERFACE ${PROJECT_SOURCE_DIR}/framework
                                                    ${PROJECT_SOURCE_DIR}/autograder)
target_compile_definitions(penumbra_flags INTERFACE GLM_FORCE_SILENT_WARNINGS)
if(NOT MSVC)
  target_compile_options(penumbra_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow=local
                                                  -ffp-contract=off)
  if(PENUMBRA_WERROR)
    target_compile_options(penumbra_flags INTERFACE -Werror)
  endif()
endif()

# course_layer(<name> LINKS <targets>): the sources of framework/<name> as an object library, and its
# *_test.cpp files as one test program. LINKS states the arrows of docs/architecture.md.
function(course_layer name)
  cmake_parse_arguments(ARG "" "" "LINKS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${name}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "(_test|main|_benchmark)\\.cpp$")
  add_library(penumbra_${name} OBJECT ${sources})
  target_link_libraries(penumbra_${name} PUBLIC penumbra_flags ${ARG_LINKS})
  file(GLOB tests CONFIGURE_DEPENDS ${name}/*_test.cpp)
  if(tests)
    add_executable(${name}_test ${tests})
    target_link_libraries(${name}_test PRIVATE penumbra GTest::gtest GTest::gtest_main)
    gtest_discover_tests(${name}_test DISCOVERY_MODE PRE_TEST
                         PROPERTIES TIMEOUT 120 ENVIRONMENT "LP_NUM_THREADS=1")
  endif()
endfunction()
include(GoogleTest)

# A variant is a stack of folders; a later one replaces files of the same name, given/ excepted.
# course_add_program(<target> <folder> …): the .cpp files of that stack with the framework's main().
function(course_add_program target)
  set(chosen "")
  foreach(folder IN LISTS ARGN)
    file(GLOB files CONFIGURE_DEPENDS ${folder}/*.cpp)
    foreach(file IN LISTS files)
      get_filename_component(name ${file} NAME)
      list(FILTER chosen EXCLUDE REGEX "/${name}$")
      list(APPEND chosen ${file})
    endforeach()
  endforeach()
  list(GET ARGN 0 handout)
  get_filename_component(assignment ${handout} NAME)
  if(NOT TARGET ${assignment}.given)  # compiled once for all variants: nothing replaces it
    file(GLOB given CONFIGURE_DEPENDS ${handout}/given/*.cpp)
    add_library(${assignment}.given OBJECT ${given})
    target_include_directories(${assignment}.given PRIVATE ${handout}/given)
    target_link_libraries(${assignment}.given PRIVATE penumbra)
  endif()
  set(objects $<TARGET_OBJECTS:${assignment}.given>)
  foreach(file IN LISTS chosen)  # compiled once, too: a mistake shares all files but one
    file(RELATIVE_PATH path ${PROJECT_SOURCE_DIR} ${file})
    string(MAKE_C_IDENTIFIER ${path} object)
    if(NOT TARGET ${object})
      add_library(${object} OBJECT ${file})
      target_include_directories(${object} PRIVATE ${handout}/given ${handout})
      target_link_libraries(${object} PRIVATE penumbra)
    endif()
    list(APPEND objects $<TARGET_OBJECTS:${object}>)
  endforeach()
  add_executable(${target} ${objects} ${PENUMBRA_FRAMEWORK}/app/main.cpp)
  string(REPLACE ";" "|" layers "${ARGN}")
  target_compile_definitions(${target} PRIVATE PENUMBRA_LAYERS="${layers}")
  target_link_libraries(${target} PRIVATE penumbra)
endfunction()
set(PENUMBRA_FRAMEWORK ${PROJECT_SOURCE_DIR}/framework)

function(course_add_window_test assignment program solution)
  file(GLOB shaders CONFIGURE_DEPENDS ${solution}/*.glsl)
  if(NOT shaders OR NOT UNIX OR APPLE)
    return()
  endif()
  add_test(NAME ${assignment}.window COMMAND ${PENUMBRA_FRAMEWORK}/app/viewer_test.sh
                                           $<TARGET_FILE:${program}> ${shaders})
  set_tests_properties(${assignment}.window PROPERTIES TIMEOUT 120 SKIP_RETURN_CODE 77)
endfunction()

# Every folder of assignments/ is an assignment; no list names it.
function(course_add_all_assignments)
  file(GLOB handouts CONFIGURE_DEPENDS LIST_DIRECTORIES true ${PROJECT_SOURCE_DIR}/assignments/*)
  foreach(handout IN LISTS handouts)
    get_filename_component(name ${handout} NAME)
    if(NOT EXISTS ${handout}/given)
      continue()
    endif()
    course_add_program(${name} ${handout})
    set(solution ${PROJECT_SOURCE_DIR}/solutions/${name})
    if(EXISTS ${solution})
      course_add_program(${name}.solution ${handout} ${solution})
      course_add_window_test(${name} ${name}.solution ${solution})
      if(UNIX)
        add_test(NAME ${name}.headless
                 COMMAND ${PENUMBRA_FRAMEWORK}/app/headless_test.sh $<TARGET_FILE:${name}.solution>)
        set_tests_properties(${name}.headless PROPERTIES TIMEOUT 120 ENVIRONMENT "LP_NUM_THREADS=1")
      endif()
      file(GLOB mistakes CONFIGURE_DEPENDS LIST_DIRECTORIES true
           ${PROJECT_SOURCE_DIR}/autograder/${name}/wrong/*)
      foreach(mistake IN LISTS mistakes)
        file(GLOB cpp ${mistake}/*.cpp)
        if(cpp)  # a mistake in GLSL alone runs the solution's program with one more folder
          get_filename_component(label ${mistake} NAME)
          course_add_program(${name}.wrong.${label} ${handout} ${solution} ${mistake})
        endif()
      endforeach()
    endif()
  endforeach()
endfunction()

# <N>.grade from autograder/<N>/*.cpp, and in a tree with solutions the tests that grade the grader.
function(course_add_grader name)
  set(grader ${PROJECT_SOURCE_DIR}/autograder/${name})
  file(GLOB checks CONFIGURE_DEPENDS ${grader}/*.cpp)
  add_executable(${name}.grade ${PENUMBRA_FRAMEWORK}/../autograder/core/grade_main.cpp ${checks})
  target_link_libraries(${name}.grade PRIVATE penumbra_autograder)
  target_compile_definitions(${name}.grade PRIVATE PENUMBRA_ROOT="${PROJECT_SOURCE_DIR}"
                                                   PENUMBRA_BUILD="${CMAKE_BINARY_DIR}"
                                                   PENUMBRA_ASSIGNMENT="${name}")
  if(NOT EXISTS ${PROJECT_SOURCE_DIR}/solutions/${name})
    return()  # a student's tree: the handout is being written, nothing to hold it against
  endif()
  set(out ${CMAKE_BINARY_DIR}/grades/${name})
  # Mistakes share truths and compiled shaders; the solution is graded without, as students are.
  set(caches --truth-cache ${CMAKE_BINARY_DIR}/grades/truths
             --shader-cache ${CMAKE_BINARY_DIR}/grades/shaders)
  add_test(NAME ${name}.hashes COMMAND ${name}.grade --handout-hashes)
  add_test(NAME ${name}.solution COMMAND ${name}.grade --solution --out ${out}/solution)
  add_test(NAME ${name}.cached COMMAND ${name}.grade --solution --out ${out}/cached ${caches}
           --expect-same ${out}/solution)
  set_tests_properties(${name}.solution PROPERTIES FIXTURES_SETUP ${name}.graded)
  set_tests_properties(${name}.cached PROPERTIES FIXTURES_REQUIRED ${name}.graded)
  add_test(NAME ${name}.handout COMMAND ${name}.grade --expect-not-started --out ${out}/handout)
  # The solution handed in like a student's work: where it holds C++, this builds it on its own.
  add_test(NAME ${name}.submission COMMAND ${name}.grade --out ${out}/submission
           --submission ${PROJECT_SOURCE_DIR}/solutions/${name})
  # Long ones first, so that no core waits for the last: the solution's runs fill the caches.
  set_tests_properties(${name}.solution ${name}.cached ${name}.submission PROPERTIES COST 100)
  set(all ${name}.hashes ${name}.solution ${name}.cached ${name}.handout ${name}.submission)
  file(GLOB curves CONFIGURE_DEPENDS ${grader}/curves*.cpp)
  if(curves)  # each states facts
    add_test(NAME ${name}.curves COMMAND ${name}.grade --curves --solution --out ${out}/curves ${caches})
    list(APPEND all ${name}.curves)
  endif()
  file(GLOB mistakes CONFIGURE_DEPENDS LIST_DIRECTORIES true ${grader}/wrong/*)
  foreach(mistake IN LISTS mistakes)
    get_filename_component(label ${mistake} NAME)
    add_test(NAME ${name}.wrong.${label}
             COMMAND ${name}.grade --wrong ${label} --expect-mistake --out ${out}/wrong/${label}
                     ${caches})
    set_tests_properties(${name}.wrong.${label} PROPERTIES COST 10)
    list(APPEND all ${name}.wrong.${label})
  endforeach()
  set_tests_properties(${all} PROPERTIES TIMEOUT 300 LABELS grader ENVIRONMENT "LP_NUM_THREADS=1")
endfunction()

function(course_add_all_graders)
  file(GLOB graders CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/autograder/*/rubric.json)
  foreach(grader IN LISTS graders)
    get_filename_component(folder ${grader} DIRECTORY)
    get_filename_component(name ${folder} NAME)
    course_add_grader(${name})
  endforeach()
endfunction()

# Every header compiles alone: one generated .cpp each, in a library that nothing links.
function(course_check_headers_alone)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/framework/*.h
       ${PROJECT_SOURCE_DIR}/autograder/*.h)
  set(sources "")
  foreach(header IN LISTS headers)
    file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR} ${header})
    string(REPLACE "/" "_" stem ${name})
    set(source ${CMAKE_BINARY_DIR}/headers/${stem}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${header}\"\n")
    list(APPEND sources ${source})
  endforeach()
  add_library(penumbra_headers_alone OBJECT ${sources})
  target_link_libraries(penumbra_headers_alone PRIVATE penumbra GTest::gtest)
endfunction()
