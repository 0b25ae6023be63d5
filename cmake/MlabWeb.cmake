# The web client as part of the build: the target `web`, which puts it where the command finds it and where it is
# installed from. Node and npm are looked for when it is built, not here: most build folders never do.

option(MLAB_WEB "build the web client (needs npm)" ON)
set(MLAB_WEB_FOLDER ${CMAKE_BINARY_DIR}/web CACHE PATH "where the web client is built; build folders may share one")

file(GLOB_RECURSE web_sources CONFIGURE_DEPENDS
  ${CMAKE_SOURCE_DIR}/web/core/* ${CMAKE_SOURCE_DIR}/web/ui/* ${CMAKE_SOURCE_DIR}/web/console/* ${CMAKE_SOURCE_DIR}/web/designer/*
  ${CMAKE_SOURCE_DIR}/web/edit/* ${CMAKE_SOURCE_DIR}/web/public/* ${CMAKE_SOURCE_DIR}/web/tools/* ${CMAKE_SOURCE_DIR}/proto/*.proto ${CMAKE_SOURCE_DIR}/tools/web/*)
file(GLOB web_roots CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/web/*.json ${CMAKE_SOURCE_DIR}/web/*.ts
  ${CMAKE_SOURCE_DIR}/web/*.html ${CMAKE_SOURCE_DIR}/web/.npmrc)
set(web_out ${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_DATADIR}/mlab/web)
add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/web.stamp
  COMMAND bash ${CMAKE_SOURCE_DIR}/tools/web/build ${MLAB_WEB_FOLDER} ${web_out}
  COMMAND ${CMAKE_COMMAND} -E touch ${CMAKE_BINARY_DIR}/web.stamp
  DEPENDS ${web_sources} ${web_roots} COMMENT "Building the web client" VERBATIM)
if(MLAB_WEB)
  add_custom_target(web ALL DEPENDS ${CMAKE_BINARY_DIR}/web.stamp)
  # Without this an installation from a build folder that never built the page would lack it silently.
  install(CODE "if(NOT EXISTS \"${web_out}/index.html\")
      message(FATAL_ERROR \"the page of the console is not built: cmake --build ${CMAKE_BINARY_DIR} builds it, -DMLAB_WEB=OFF leaves it out\")
    endif()")
  install(DIRECTORY ${web_out} DESTINATION ${CMAKE_INSTALL_DATADIR}/mlab)
endif()
