# What `cmake --install` puts where:
#
#   bin/                   the programs; washfsi-report, washfsi-plot ...: the scripts
#   share/washfsi/         inputs/, scripts/, and python/, a link to where the module is
#   share/doc/washfsi/     documents;  share/man/man1/  manual pages;  share/bash-completion/  completion of options
#   lib/, include/         the library, for others: find_package(washfsi), then link washfsi::simulation or a room below it
set(WASHFSI_PYTHON_DIR lib/python3/dist-packages CACHE STRING "Folder of the Python module, below the prefix")
set(washfsi_scripts report plot study paraview write-agitator)

# The library.
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/washfsi)
configure_package_config_file(cmake/washfsi-config.cmake.in ${CMAKE_BINARY_DIR}/washfsi-config.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/washfsi-config-version.cmake COMPATIBILITY SameMinorVersion)
set_target_properties(washfsi_abi PROPERTIES EXPORT_NAME abi)
install(TARGETS washfsi_abi EXPORT washfsi)
install(EXPORT washfsi NAMESPACE washfsi:: FILE washfsi-targets.cmake DESTINATION ${package})
install(FILES ${CMAKE_BINARY_DIR}/washfsi-config.cmake ${CMAKE_BINARY_DIR}/washfsi-config-version.cmake
        DESTINATION ${package})
install(DIRECTORY lib/washfsi DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")

# Module, scripts, cases.
set(share ${CMAKE_INSTALL_DATADIR}/washfsi)
install(DIRECTORY python/washfsi DESTINATION ${WASHFSI_PYTHON_DIR} COMPONENT python FILES_MATCHING
        PATTERN "*.py" PATTERN "*.js" PATTERN "*.css" PATTERN "*.html")
install(DIRECTORY inputs DESTINATION ${share})

# Links at their places below the prefix; the scripts find the module as they do in the source.
file(RELATIVE_PATH to_module /${share} /${WASHFSI_PYTHON_DIR})
file(RELATIVE_PATH to_scripts /${CMAKE_INSTALL_BINDIR} /${share}/scripts)
function(washfsi_install_link target folder name)
  install(CODE "file(MAKE_DIRECTORY \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${folder}\")
file(CREATE_LINK ${target} \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${folder}/${name}\" SYMBOLIC)")
endfunction()
washfsi_install_link(${to_module} ${share} python)
install(FILES scripts/results_packages.py DESTINATION ${share}/scripts)
foreach(script IN LISTS washfsi_scripts)
  install(PROGRAMS scripts/${script} DESTINATION ${share}/scripts)
  washfsi_install_link(${to_scripts}/${script} ${CMAKE_INSTALL_BINDIR} washfsi-${script})
endforeach()

# Documents. Manual pages and completion are made from the program's own list of options.
install(FILES LICENSE README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs PATTERN site EXCLUDE)
set(manual ${CMAKE_BINARY_DIR}/manual)
set(script_sources ${washfsi_scripts})
list(TRANSFORM script_sources PREPEND ${PROJECT_SOURCE_DIR}/scripts/)
add_custom_command(OUTPUT ${manual}/washfsi.1 ${manual}/washfsi.bash COMMENT ""
  COMMAND ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0 ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/cmake/write_manual.py
          $<TARGET_FILE:washfsi> ${manual} ${script_sources}
  DEPENDS washfsi cmake/write_manual.py cmake/completion.bash.in ${script_sources})
add_custom_target(washfsi_manual ALL DEPENDS ${manual}/washfsi.1)
install(DIRECTORY ${manual}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 FILES_MATCHING PATTERN "*.1")
install(FILES ${manual}/washfsi.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME washfsi)
