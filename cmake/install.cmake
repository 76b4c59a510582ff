# What an installation has: the program, its parameter files, the scripts that
# draw, the module for Python, the manual (as a site if scripts/document has made
# it), a man page made from --help, completion for bash; and a Debian package of
# these, scripts/package.

include(GNUInstallDirs)

install(TARGETS thermocontact RUNTIME)

set(share ${CMAKE_INSTALL_DATADIR}/thermocontact)
install(DIRECTORY prm DESTINATION ${share})
file(GLOB drawing_modules RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}
  scripts/plot_*.py scripts/paraview_*.py)
install(FILES ${drawing_modules} DESTINATION ${share}/scripts)
install(PROGRAMS scripts/plot scripts/paraview DESTINATION ${share}/scripts)
foreach(name plot paraview)
  set(installed thermocontact-${name})
  file(RELATIVE_PATH script ${CMAKE_INSTALL_FULL_BINDIR}
    ${CMAKE_INSTALL_FULL_DATADIR}/thermocontact/scripts/${installed})
  configure_file(cmake/script.in ${CMAKE_CURRENT_BINARY_DIR}/bin/${installed} @ONLY)
  install(PROGRAMS ${CMAKE_CURRENT_BINARY_DIR}/bin/${installed}
    DESTINATION ${CMAKE_INSTALL_BINDIR})
  # the script calls itself by the name of the link
  file(CREATE_LINK ${name} ${CMAKE_CURRENT_BINARY_DIR}/${installed} SYMBOLIC)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${installed}
    DESTINATION ${share}/scripts)
endforeach()

install(DIRECTORY python/thermocontact
  DESTINATION lib/python3/dist-packages
  PATTERN __pycache__ EXCLUDE)

install(FILES scripts/completion.bash
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  RENAME thermocontact)
install(FILES README.md CHANGELOG.md CONTRIBUTING.md CITATION.cff Dockerfile
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY doc DESTINATION ${CMAKE_INSTALL_DOCDIR}
  FILES_MATCHING PATTERN *.md PATTERN *.ipynb PATTERN *.png)
install(FILES tests/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/tests)
install(DIRECTORY prm DESTINATION ${CMAKE_INSTALL_DOCDIR}) # links of the pages
install(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/doc/html
  DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)

find_program(HELP2MAN_EXECUTABLE help2man)
mark_as_advanced(HELP2MAN_EXECUTABLE)
if(HELP2MAN_EXECUTABLE)
  set(man_page ${CMAKE_CURRENT_BINARY_DIR}/thermocontact.1)
  add_custom_command(OUTPUT ${man_page}
    COMMAND ${HELP2MAN_EXECUTABLE} --no-info --output=${man_page}
      "--name=dynamic contact of a thermoviscoelastic rod" $<TARGET_FILE:thermocontact>
    DEPENDS thermocontact
    VERBATIM)
  add_custom_target(man ALL DEPENDS ${man_page})
  install(FILES ${man_page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
else()
  message(STATUS "No man page: help2man not found")
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME thermocontact)
set(CPACK_PACKAGE_VENDOR thermocontact)
set(CPACK_PACKAGE_CONTACT "the authors of thermocontact <thermocontact@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY
  "Dynamic contact of a thermoviscoelastic rod with an obstacle")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS
  "python3-matplotlib, python3-numpy, openmpi-bin")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "paraview, python3-paraview, xvfb, python3-pandas, python3-meshio")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA
  ${CMAKE_CURRENT_SOURCE_DIR}/cmake/debian/prerm)
include(CPack)
