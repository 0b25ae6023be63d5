# clang-tidy as targets of the build: `tidy` reads every source of ours that the build compiles, `tidy_TARGET` those of one
# target, several in one piece as they are compiled. Like a compiler it is run by ninja: side by side, and only where a
# source, a header of ours, the options, the configuration or clang-tidy has changed since it found nothing.

find_program(MLAB_CLANG_TIDY clang-tidy-19)
set(MLAB_TIDY_FOLDER ${CMAKE_SOURCE_DIR}/tools/clang_tidy)

# Without the plugin clang-tidy finds the same, in three times the time: an empty file stands for one that does not compile.
set(MLAB_TIDY_PLUGIN ${CMAKE_BINARY_DIR}/own_code.so)
if(MLAB_CLANG_TIDY AND NOT MLAB_SANITIZE)
  add_custom_command(OUTPUT ${MLAB_TIDY_PLUGIN}
    COMMAND ${CMAKE_CXX_COMPILER} -std=c++17 -O1 -fPIC -fno-rtti -shared -isystem /usr/lib/llvm-19/include
      ${MLAB_TIDY_FOLDER}/own_code.cc -o ${MLAB_TIDY_PLUGIN} || ${CMAKE_COMMAND} -E touch ${MLAB_TIDY_PLUGIN}
    DEPENDS ${MLAB_TIDY_FOLDER}/own_code.cc COMMENT "Compiling the plugin of clang-tidy" VERBATIM)
  add_custom_target(tidy_plugin DEPENDS ${MLAB_TIDY_PLUGIN})
  add_custom_target(tidy)
endif()

# Declares what reads the targets of this folder, once all that is said of them has been said. Called by whatever declares
# one; a second call does nothing.
function(mlab_tidy_folder)
  if(NOT TARGET tidy)
    return()
  endif()
  cmake_language(DEFER GET_CALL_IDS calls)
  if(NOT "mlab_tidy" IN_LIST calls)
    cmake_language(DEFER ID mlab_tidy CALL mlab_tidy_targets)
  endif()
endfunction()

function(mlab_tidy_targets)
  get_property(targets DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type MATCHES "^(STATIC_LIBRARY|EXECUTABLE|MODULE_LIBRARY)$")
      mlab_tidy_target(${target} ${type})
    endif()
  endforeach()
endfunction()

# An object library of the same sources, whose "compiler" is tools/clang_tidy/read.
function(mlab_tidy_target target type)
  get_target_property(sources ${target} SOURCES)
  list(TRANSFORM sources PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ REGEX "^[^/$]")
  list(FILTER sources INCLUDE REGEX "^${CMAKE_SOURCE_DIR}/.*\\.cc$")
  list(FILTER sources EXCLUDE REGEX "^${CMAKE_BINARY_DIR}/")
  if(NOT sources)
    return()
  endif()
  add_library(tidy_${target} OBJECT EXCLUDE_FROM_ALL ${sources})
  get_target_property(libraries ${target} LINK_LIBRARIES)
  if(libraries)
    target_link_libraries(tidy_${target} PRIVATE ${libraries})
  endif()
  if(type STREQUAL STATIC_LIBRARY)
    target_link_libraries(tidy_${target} PRIVATE ${target})
  endif()
  target_include_directories(tidy_${target} PRIVATE $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
  target_compile_definitions(tidy_${target} PRIVATE $<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>)
  get_target_property(is_unity ${target} UNITY_BUILD)
  get_target_property(batch ${target} UNITY_BUILD_BATCH_SIZE)
  set_target_properties(tidy_${target} PROPERTIES
    UNITY_BUILD ${is_unity}
    UNITY_BUILD_BATCH_SIZE ${batch}
    EXPORT_COMPILE_COMMANDS OFF
    CXX_COMPILER_LAUNCHER "bash;${MLAB_TIDY_FOLDER}/read;${MLAB_CLANG_TIDY};${MLAB_TIDY_PLUGIN}")
  add_dependencies(tidy_${target} tidy_plugin)
  add_dependencies(tidy tidy_${target})
endfunction()
