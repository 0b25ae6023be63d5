# `cmake --install` and the Debian package: the command, what it reads, and what authors of behaviors build against.

include(CMakePackageConfigHelpers)

foreach(program mlab cnlc)
  if(TARGET ${program})
    install(TARGETS ${program} EXPORT mlabTargets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
endforeach()
install(EXPORT mlabTargets NAMESPACE mlab:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/mlab)
configure_package_config_file(${CMAKE_SOURCE_DIR}/cmake/mlab-config.cmake.in ${CMAKE_BINARY_DIR}/mlab-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/mlab)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/mlab-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/mlab-config.cmake ${CMAKE_BINARY_DIR}/mlab-config-version.cmake
  ${CMAKE_SOURCE_DIR}/cmake/MlabProcedures.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/mlab)

foreach(folder missions library docs)
  if(EXISTS ${CMAKE_SOURCE_DIR}/${folder})
    install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_DATADIR}/mlab PATTERN CMakeLists.txt EXCLUDE)
  endif()
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME mlab)
set(CPACK_PACKAGE_CONTACT "the missionlab maintainers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_STRIP_FILES ON)
# What compiles the procedures that a mission brings along, and what the headers of the modules include.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "g++, libfmt-dev")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "bubblewrap, cmake, nlohmann-json3-dev, libtbb-dev")
include(CPack)
