# What every target of the project is compiled with, and the functions that declare modules, fuzzers and tests.

find_program(MLAB_MOLD mold)
find_program(MLAB_CCACHE ccache)
if(MLAB_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Paths count from the clone's own folder, so that clones share what they compiled.
  set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${MLAB_CCACHE})
  if(MLAB_SANITIZE)
    # It keeps what was compiled with headers that were read before only where it is told that this is meant.
    list(INSERT CMAKE_CXX_COMPILER_LAUNCHER 1 CCACHE_SLOPPINESS=pch_defines,time_macros)
  endif()
endif()
# GCC for another machine looks for linkers of that machine's own only.
if(MLAB_MOLD AND NOT CMAKE_CROSSCOMPILING)
  add_link_options(-fuse-ld=mold)
endif()

add_library(mlab_options INTERFACE)
# -ffp-contract=off: the same arithmetic everywhere, so that a run repeats bit for bit.
target_compile_options(mlab_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -ffp-contract=off)
if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  # On ARM a `char` has no sign unless it is asked for.
  target_compile_options(mlab_options INTERFACE -fsigned-char)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Clang builds only for sanitizers and fuzzers; what it alone warns about is clang-tidy's business.
  # -Wrestrict: GCC 12 sees overlapping copies in std::string's own operator+ (GCC bug 105329).
  # -Wmaybe-uninitialized: it takes the members of a std::variant that are not in use for values (GCC bug 105562);
  # the sanitizers find what is really read too early.
  target_compile_options(mlab_options INTERFACE -Werror -Wno-restrict -Wno-maybe-uninitialized)
endif()
if(MLAB_SANITIZE)
  string(REPLACE ";" "," sanitizers "${MLAB_SANITIZE}")
  target_compile_options(mlab_options INTERFACE -fsanitize=${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(mlab_options INTERFACE -fsanitize=${sanitizers})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    # Tests link robot executables with g++, whose runtime of these sanitizers doesn't know this one of clang's.
    target_compile_options(mlab_options INTERFACE -fno-sanitize=function)
  endif()
  if(sanitizers STREQUAL thread)
    target_compile_definitions(mlab_options INTERFACE MLAB_SANITIZE_THREAD)
  endif()
endif()
# For what fuzzers look into, too: they choose their inputs by what these options count. Tests, which fuzzers never see, are
# compiled in five sixths of the time without them.
add_library(mlab_counted INTERFACE)
target_link_libraries(mlab_counted INTERFACE mlab_options)
if(MLAB_FUZZ)
  target_compile_options(mlab_counted INTERFACE -fsanitize=fuzzer-no-link)
endif()
# What most tests spend their time in. With sanitizers it is optimised even where nothing else is: it takes twice as long to
# compile, and their longest tests a fifth of the time to run. They look at what is left of reads and writes once it is
# optimised, so at none whose result nobody uses.
set(MLAB_BUSY_MODULES base geom fleet binding simulated run robot library ways schema text mcap overlay flow mission odl envchange mdl cnl cdl cdl_historic sim assist mavlink ros2 vehicle model_vehicles)

# What a control cycle is spent in. Functions that are called in the source where they stand may be put in place there, though
# it is compiled for shared libraries, too: nobody exchanges functions of ours when a program starts. And nobody asks `errno`
# what sqrt thinks of a number. GCC 12 would store a point's halves one by one, as it gets them, to read both at once, for which
# the processor waits until they are in the cache (-fno-tree-slp-vectorize). Results stay the same to the last bit.
set(MLAB_CYCLE_MODULES percept flow schema ways binding sim fleet robot library mission run)
# Those of them that go through lists and grids are made as fast as can be. All others are called once for each robot, one
# after the other: what is smaller is faster there, since a robot's whole program fits into the cache of instructions then.
set(MLAB_LOOP_MODULES flow sim)
function(mlab_tune_if_in_cycle name)
  if(name IN_LIST MLAB_CYCLE_MODULES)
    target_compile_options(mlab_${name} PRIVATE -fno-semantic-interposition -fno-math-errno -fno-tree-slp-vectorize)
    if(name IN_LIST MLAB_LOOP_MODULES)
      target_compile_options(mlab_${name} PRIVATE $<$<CONFIG:Release>:-O3>)
    endif()
  endif()
endfunction()

# Everything that `./mlab test` builds for the sanitizers: all unit tests; the tests of code with threads; the fuzzers.
add_custom_target(unit_tests)
add_custom_target(threaded_tests)
add_custom_target(fuzzers)
# Whose tests run robots with procedures of their own, in the program that hosts those.
set(MLAB_HOSTING_MODULES robot robot_build simulated assist lsp console designer)

# For the library mlab_NAME: optimises it with sanitizers where NAME is among those.
function(mlab_optimise_if_busy name)
  if(MLAB_SANITIZE AND name IN_LIST MLAB_BUSY_MODULES)
    target_compile_options(mlab_${name} PRIVATE $<$<CONFIG:Debug>:-O1>)
  endif()
endfunction()

# The same for files of a test that it spends its time in.
function(mlab_optimise_busy_files)
  if(MLAB_SANITIZE)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS $<$<CONFIG:Debug>:-O1> SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()

# mlab_module(NAME [SOURCES file...] [TESTS file...] [THREADED_TESTS file...] [LINK target...] [TEST_LINK target...])
#
# The static library mlab_NAME out of SOURCES (header-only without), that links LINK; and the test program
# mlab_NAME_test out of TESTS and THREADED_TESTS. The latter start threads, and what they need: of them alone it is made
# for the thread sanitizer, which finds nothing in the others. Installed, the library is mlab::NAME, with the headers of
# the folder.
function(mlab_module name)
  mlab_tidy_folder()
  cmake_parse_arguments(arg "" "" "SOURCES;TESTS;THREADED_TESTS;LINK;TEST_LINK" ${ARGN})
  if(arg_SOURCES)
    add_library(mlab_${name} STATIC ${arg_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(mlab_${name} PRIVATE $<BUILD_INTERFACE:mlab_counted>)
    mlab_optimise_if_busy(${name})
    mlab_tune_if_in_cycle(${name})
  else()
    add_library(mlab_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(mlab_${name} ${scope} $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/src>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(mlab_${name} ${scope} ${arg_LINK})
  target_compile_features(mlab_${name} INTERFACE cxx_std_23)
  # Headers hold arithmetic too, so who uses them computes the same way.
  target_compile_options(mlab_${name} INTERFACE "$<INSTALL_INTERFACE:-ffp-contract=off;-fsigned-char>")
  add_library(mlab::${name} ALIAS mlab_${name})

  set_target_properties(mlab_${name} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS mlab_${name} EXPORT mlabTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  file(RELATIVE_PATH folder ${CMAKE_SOURCE_DIR}/src ${CMAKE_CURRENT_SOURCE_DIR})
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${folder} FILES_MATCHING PATTERN "*.h"
    PATTERN testing EXCLUDE)

  set(tests ${arg_THREADED_TESTS})
  if(NOT MLAB_SANITIZE STREQUAL thread)
    list(APPEND tests ${arg_TESTS})
  endif()
  if(MLAB_TESTS AND tests)
    set(label "")
    if(arg_THREADED_TESTS)
      set(label LABEL threads)
    endif()
    mlab_test(mlab_${name}_test SOURCES ${tests} LINK mlab_${name} ${arg_TEST_LINK} ${label})
    add_dependencies(unit_tests mlab_${name}_test)
    if(name IN_LIST MLAB_HOSTING_MODULES)
      add_dependencies(mlab_${name}_test mlab-robots)
    endif()
    if(label)
      add_dependencies(threaded_tests mlab_${name}_test)
    endif()
  endif()
endfunction()

# What all tests include, read once for all of them. Only with sanitizers, of which one compiler makes all: it saves a test program
# a second and a half.
if(MLAB_TESTS AND MLAB_SANITIZE)
  add_executable(mlab_test_headers EXCLUDE_FROM_ALL ${CMAKE_SOURCE_DIR}/cmake/test_headers.cc)
  target_link_libraries(mlab_test_headers PRIVATE mlab_options GTest::gtest GTest::gtest_main)
  target_precompile_headers(mlab_test_headers PRIVATE <gtest/gtest.h>)
  # Else it would differ each time.
  target_compile_options(mlab_test_headers PRIVATE $<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>)
endif()

# mlab_test(NAME SOURCES file... [LINK target...] [LABEL label])
#
# A GoogleTest program, each of its tests one test of ctest. LABEL: `repo` (rules of the source tree), `e2e` (missions
# and command line); without, or with `threads` (which the thread sanitizer sees too), they are unit tests.
function(mlab_test name)
  mlab_tidy_folder()
  cmake_parse_arguments(arg "" "LABEL" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  # Tests of one thing are alike: more of them in one piece would have names in common.
  set_target_properties(${name} PROPERTIES UNITY_BUILD_BATCH_SIZE 8)
  # It replaces operators new and delete, which a compiler that sees them beside their callers takes for mismatched.
  set_source_files_properties(../base/testing/count_allocations.cc PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_link_libraries(${name} PRIVATE ${arg_LINK} mlab_source_folder mlab_options GTest::gtest GTest::gtest_main)
  if(MLAB_SANITIZE)
    target_precompile_headers(${name} REUSE_FROM mlab_test_headers)
  endif()
  # What is tested is compiled as in the product; what asks, in less time.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O0>)
  set(properties "")
  if(arg_LABEL)
    set(properties PROPERTIES LABELS ${arg_LABEL})
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 NO_PRETTY_VALUES ${properties})
endfunction()

# mlab_fuzzer(NAME SOURCES file... [LINK target...] [SEEDS folder] [DICTIONARY file])
#
# A libFuzzer program (it defines LLVMFuzzerTestOneInput), built where MLAB_FUZZ is on. SEEDS is a folder of inputs to
# start from, DICTIONARY a file of words (libFuzzer's format). A finding is kept in `found` of the build folder.
function(mlab_fuzzer name)
  cmake_parse_arguments(arg "" "SEEDS;DICTIONARY" "SOURCES;LINK" ${ARGN})
  if(NOT MLAB_FUZZ)
    return()
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} mlab_counted)
  target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  add_dependencies(fuzzers ${name})
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/corpus/${name} ${CMAKE_BINARY_DIR}/found)
  set(options "")
  if(arg_DICTIONARY)
    list(APPEND options -dict=${CMAKE_CURRENT_SOURCE_DIR}/${arg_DICTIONARY})
  endif()
  set(seeds "")
  if(arg_SEEDS)
    cmake_path(ABSOLUTE_PATH arg_SEEDS BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE seeds)
  endif()
  add_test(NAME fuzz.${name} COMMAND ${name} -seed=1 -max_total_time=${MLAB_FUZZ_SECONDS} -timeout=10 -rss_limit_mb=2048
    -print_final_stats=1 -artifact_prefix=${CMAKE_BINARY_DIR}/found/${name}- ${options}
    ${CMAKE_BINARY_DIR}/corpus/${name} ${seeds})
  set_tests_properties(fuzz.${name} PROPERTIES LABELS fuzz)
endfunction()
