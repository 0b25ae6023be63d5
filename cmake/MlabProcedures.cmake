# mlab_add_procedures(TARGET FILE.cnl...)
#
# Compiles procedures written in CNL into TARGET, an existing library or program. Each FILE.cnl adds the function
#   std::span<const mlab::flow::Behavior* const> mlab_cnl_<name of the file>();
# and all together the function
#   std::span<const mlab::flow::Behavior* const> mlab_<TARGET>_behaviors();
# where a leading `mlab_` of TARGET is not repeated. TARGET has to link mlab::schema itself.
# The compiler is the target `cnlc`, or `mlab::cnlc` where the project is used through find_package(mlab). Where all that is
# built is for another machine, MLAB_CNLC is one that this machine can run.
set(MLAB_CNLC "" CACHE FILEPATH "a cnlc that runs on this machine, to build for another one")
function(mlab_add_procedures target)
  if(MLAB_CNLC)
    set(compiler ${MLAB_CNLC})
  elseif(CMAKE_CROSSCOMPILING)
    message(FATAL_ERROR "MLAB_CNLC is not set: to build for another machine, it names a cnlc that this one can run")
  elseif(TARGET cnlc)
    set(compiler cnlc)
  else()
    set(compiler mlab::cnlc)
  endif()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_cnl)
  file(MAKE_DIRECTORY ${folder})
  set(sources "")
  set(inputs "")
  set(folders "")
  foreach(file IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE OUTPUT_VARIABLE input)
    cmake_path(GET input STEM LAST_ONLY stem)
    set(output ${folder}/${stem}.cnl.cc)
    add_custom_command(OUTPUT ${output}
      COMMAND ${compiler} ${input} -o ${output} --depfile ${output}.d
      DEPENDS ${input} ${compiler} DEPFILE ${output}.d COMMENT "Compiling ${stem}.cnl" VERBATIM)
    cmake_path(GET input PARENT_PATH own_folder)
    list(APPEND folders ${own_folder})
    list(APPEND sources ${output})
    list(APPEND inputs ${input})
  endforeach()
  # What `init` includes is looked for beside the file. Sources with options of their own are never compiled in one piece.
  list(REMOVE_DUPLICATES folders)
  list(LENGTH folders count)
  if(count EQUAL 1)
    target_compile_options(${target} PRIVATE -iquote${folders})
  else()
    foreach(input output IN ZIP_LISTS inputs sources)
      cmake_path(GET input PARENT_PATH own_folder)
      set_source_files_properties(${output} PROPERTIES COMPILE_OPTIONS "-iquote${own_folder}")
    endforeach()
  endif()
  string(REGEX REPLACE "^mlab_" "" name ${target})
  string(MAKE_C_IDENTIFIER ${name} name)
  set(table ${folder}/table.cc)
  add_custom_command(OUTPUT ${table}
    COMMAND ${compiler} --table ${inputs} --name mlab_${name}_behaviors -o ${table}
    DEPENDS ${compiler} COMMENT "Listing the procedures of ${target}" VERBATIM)
  target_sources(${target} PRIVATE ${sources} ${table})
  # `sources` differ in nothing but their text, so the order in which files are named is the order of the table.
endfunction()
