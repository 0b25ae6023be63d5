# What every target of the project is compiled with, and one function that declares a module.

find_program(MLAB_MOLD mold)
find_program(MLAB_CCACHE ccache)
if(MLAB_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${MLAB_CCACHE})
endif()
if(MLAB_MOLD)
  add_link_options(-fuse-ld=mold)
endif()

add_library(mlab_options INTERFACE)
# -ffp-contract=off: the same arithmetic everywhere, so that a run repeats bit for bit.
target_compile_options(mlab_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Werror -ffp-contract=off)
if(MLAB_SANITIZE)
  string(REPLACE ";" "," sanitizers "${MLAB_SANITIZE}")
  target_compile_options(mlab_options INTERFACE -fsanitize=${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(mlab_options INTERFACE -fsanitize=${sanitizers})
endif()

# mlab_module(NAME [SOURCES file...] [TESTS file...] [LINK target...] [TEST_LINK target...])
#
# The static library mlab_NAME out of SOURCES (header-only without), that links LINK; and the test program
# mlab_NAME_test out of TESTS.
function(mlab_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;TESTS;LINK;TEST_LINK" ${ARGN})
  if(arg_SOURCES)
    add_library(mlab_${name} STATIC ${arg_SOURCES})
    target_include_directories(mlab_${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/src>)
    target_link_libraries(mlab_${name} PUBLIC ${arg_LINK} PRIVATE $<BUILD_INTERFACE:mlab_options>)
  else()
    add_library(mlab_${name} INTERFACE)
    target_include_directories(mlab_${name} INTERFACE $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/src>)
    target_link_libraries(mlab_${name} INTERFACE ${arg_LINK})
  endif()
  if(MLAB_TESTS AND arg_TESTS)
    add_executable(mlab_${name}_test ${arg_TESTS})
    target_link_libraries(mlab_${name}_test PRIVATE mlab_${name} mlab_options ${arg_TEST_LINK} GTest::gtest GTest::gtest_main)
    target_compile_definitions(mlab_${name}_test PRIVATE MLAB_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
    gtest_discover_tests(mlab_${name}_test DISCOVERY_TIMEOUT 60)
  endif()
endfunction()
