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

foreach(folder missions examples library docs)
  if(EXISTS ${CMAKE_SOURCE_DIR}/${folder})
    install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_DATADIR}/mlab PATTERN CMakeLists.txt EXCLUDE)
  endif()
endforeach()

# Completions and manual pages, out of the built command itself.
set(shell_files ${CMAKE_BINARY_DIR}/shell_files)
add_custom_command(OUTPUT ${shell_files}.stamp
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${shell_files}
  COMMAND mlab write-shell-files ${shell_files}
  COMMAND ${CMAKE_COMMAND} -E touch ${shell_files}.stamp
  DEPENDS mlab COMMENT "Writing completions and manual pages" VERBATIM)
add_custom_target(shell_files ALL DEPENDS ${shell_files}.stamp)
install(DIRECTORY ${shell_files}/ DESTINATION ${CMAKE_INSTALL_DATADIR})

# What is inside and whose it is: our own, the libraries whose headers are compiled in (as their Debian packages say),
# and the packages in the web client (as its build wrote them down).
set(HEADER_NOTICES "")
foreach(package libcli11-dev nlohmann-json3-dev libfmt-dev libprotobuf-dev libtbb-dev cyclonedds-dev libtomlplusplus-dev prometheus-cpp-dev libgeographiclib-dev)
  if(EXISTS /usr/share/doc/${package}/copyright)
    file(READ /usr/share/doc/${package}/copyright notice)
    string(REGEX REPLACE "\n\n" "\n.\n" notice "${notice}")
    string(REGEX REPLACE "\n" "\n " notice "\n${notice}")
    string(APPEND HEADER_NOTICES " .\n ---- ${package}\n .${notice}\n")
  endif()
endforeach()
configure_file(${CMAKE_SOURCE_DIR}/cmake/copyright.in ${CMAKE_BINARY_DIR}/copyright @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/mlab)
if(MLAB_WEB)
  install(FILES ${web_out}/third_party_licences.txt DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/mlab RENAME web_licences.txt)
endif()

# The agent, for machines that do nothing else: a package of its own, in a folder of its own, so that both can be installed.
set(agent_folder lib/missionlab-agent)
set(for_agent COMPONENT agent EXCLUDE_FROM_ALL)
install(TARGETS mlab-agent mlab-robots RUNTIME DESTINATION ${agent_folder}/bin ${for_agent})
# What C++ that missions bring may include.
foreach(module base flow geom percept schema ways)
  install(DIRECTORY src/mlab/${module} DESTINATION ${agent_folder}/include/mlab ${for_agent} FILES_MATCHING PATTERN "*.h" PATTERN testing EXCLUDE)
endforeach()
install(DIRECTORY library/include/ DESTINATION ${agent_folder}/include ${for_agent})
install(CODE "file(MAKE_DIRECTORY \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/bin\")
  file(CREATE_LINK ../${agent_folder}/bin/mlab-agent \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/bin/mlab-agent\" SYMBOLIC)" ${for_agent})
install(FILES packaging/agent/missionlab-agent.service DESTINATION lib/systemd/system ${for_agent})
install(FILES packaging/agent/agent.conf DESTINATION /etc/missionlab ${for_agent})
install(FILES packaging/agent/mlab-agent.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 ${for_agent})
install(FILES ${CMAKE_BINARY_DIR}/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/missionlab-agent ${for_agent})

# The Python module: a package of its own, for Debian's Python. It finds programs and headers of the command's package beside it.
set(package_components Unspecified agent)
if(TARGET mlab_python)
  set(for_python COMPONENT python EXCLUDE_FROM_ALL)
  set(python_folder lib/python3/dist-packages/mlab)
  install(TARGETS mlab_python LIBRARY DESTINATION ${python_folder} ${for_python})
  install(DIRECTORY python/mlab/ DESTINATION ${python_folder} ${for_python} FILES_MATCHING PATTERN "*.py" PATTERN py.typed PATTERN __pycache__ EXCLUDE)
  install(DIRECTORY python/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-missionlab ${for_python} PATTERN __pycache__ EXCLUDE)
  install(FILES ${CMAKE_BINARY_DIR}/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-missionlab ${for_python})
  list(APPEND package_components python)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL ${package_components})
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_PACKAGE_NAME mlab)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME mlab)
set(CPACK_DEBIAN_AGENT_PACKAGE_NAME missionlab-agent)
set(CPACK_COMPONENT_UNSPECIFIED_DESCRIPTION "${PROJECT_DESCRIPTION}")
set(CPACK_COMPONENT_AGENT_DESCRIPTION "Carries robots for runs of a fleet of missionlab, on machines that do nothing else")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-missionlab)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "The Python module mlab of missionlab: missions run, repeated and learnt in from Python")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${MLAB_PYTHON_DEPENDS}")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "mlab")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas")
set(CPACK_DEBIAN_AGENT_PACKAGE_CONTROL_EXTRA ${CMAKE_SOURCE_DIR}/packaging/agent/conffiles)
set(CPACK_DEBIAN_AGENT_PACKAGE_RECOMMENDS "g++, libfmt-dev")
set(CPACK_DEBIAN_AGENT_PACKAGE_SUGGESTS "bubblewrap")
set(CPACK_PACKAGE_CONTACT "the missionlab maintainers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_STRIP_FILES ON)
# What compiles the procedures that a mission brings along, and what the headers of the modules include.
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_RECOMMENDS "g++, libfmt-dev")
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_SUGGESTS "bubblewrap, cmake, git, nlohmann-json3-dev, libtbb-dev")
include(CPack)
