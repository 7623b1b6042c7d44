# The files that other projects need to link rooms (autoref_export), and Debian packages; scripts/package writes
#   autoref          the program, its man page, completion for shells, the scenarios
#   python3-autoref  the Python package
#   libautoref-dev   libraries and headers
# There are three packages because their dependencies differ: the program needs neither Python nor headers.
include(CMakePackageConfigHelpers)
set(packages ${CMAKE_CURRENT_SOURCE_DIR}/cmake/packages)
set(config ${CMAKE_CURRENT_BINARY_DIR}/autoref-config.cmake)
set(config_version ${CMAKE_CURRENT_BINARY_DIR}/autoref-config-version.cmake)
configure_package_config_file(${packages}/autoref-config.cmake.in ${config} INSTALL_DESTINATION lib/cmake/autoref
                              NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${config_version} COMPATIBILITY SameMajorVersion)
install(EXPORT autoref FILE autoref-targets.cmake NAMESPACE autoref:: DESTINATION lib/cmake/autoref COMPONENT development)
install(FILES ${config} ${config_version} DESTINATION lib/cmake/autoref COMPONENT development)
install(DIRECTORY tests/outside_project/ DESTINATION share/doc/libautoref-dev/examples COMPONENT development
        PATTERN install_and_build EXCLUDE)
# CMake does not strip static libraries.
install(CODE [[
  file(GLOB libraries "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/lib/libautoref_*.a")
  execute_process(COMMAND strip --strip-debug ${libraries} COMMAND_ERROR_IS_FATAL ANY)
]] COMPONENT development)

include(cmake/debian_changelog.cmake)
set(maintainer "AutoRef developers <autoref@example.org>")
set(revision 1)

# Installs a package's copyright and changelog as Debian requires.
function(autoref_package_documents package component)
  set(documents ${CMAKE_CURRENT_BINARY_DIR}/documents/${package})
  autoref_debian_changelog(${CMAKE_CURRENT_SOURCE_DIR}/CHANGELOG.md ${package} ${revision} "${maintainer}" ${documents}/changelog)
  autoref_compress(${documents}/changelog ${documents}/changelog.Debian.gz)
  install(FILES ${packages}/copyright ${documents}/changelog.Debian.gz DESTINATION share/doc/${package} COMPONENT ${component})
endfunction()
autoref_package_documents(autoref program)
autoref_package_documents(libautoref-dev development)
# The pages keep their relative locations.
foreach(folder IN ITEMS . ${AUTOREF_ROOMS} benchmarks python tools)
  install(FILES ${folder}/README.md DESTINATION share/doc/autoref/${folder} COMPONENT program)
endforeach()
install(DIRECTORY docs DESTINATION share/doc/autoref COMPONENT program FILES_MATCHING PATTERN "*.md")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_VENDOR AutoRef)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${revision})
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${maintainer}")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# The libraries that the programs need, found by dpkg-shlibdeps.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

# CPack would put the project's description before each package's own.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(about "The state machine of Zhu, Biswas and Veloso's paper on AutoRef referees
complete games, 6 against 6, about a thousand times faster than real time.
Hundreds of games, played in parallel, show which team wins.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME autoref)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS python3-autoref)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "simulator of robot soccer games with a built-in referee\n${about}")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libautoref-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libbox2d-dev, libboost-dev, libeigen3-dev, libfmt-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "libraries of AutoRef's referee and simulator\n${about}

This package contains C++ libraries and headers: with them, a program judges
frames of its own.")

if(TARGET autoref_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  autoref_package_documents(python3-autoref python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-autoref)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  # The compiled part works only with one version of Python, such as 3.11.
  get_target_property(python autoref_python AUTOREF_PYTHON_VERSION)
  string(REGEX MATCH "[0-9]+$" minor ${python})
  math(EXPR next_minor "${minor} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "autoref (= ${PROJECT_VERSION}-${revision}), python3 (>= ${python}), python3 (<< 3.${next_minor})")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS python3-numpy)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${packages}/postinst;${packages}/prerm")
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "teams, games and results of AutoRef in Python\n${about}

This package contains the Python package: teams in Python, games in your
process, results as tables.")
endif()
include(CPack)
