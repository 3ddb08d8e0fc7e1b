# Installs the program, the texts that it prints about itself, the examples and the licence, all
# as the component `program`. The component `debian` has what only a Debian package holds.
include(GNUInstallDirs)

set(documents ${CMAKE_CURRENT_BINARY_DIR}/documents)
file(MAKE_DIRECTORY ${documents})
set(scripts "")
foreach(shell bash zsh fish)
  list(APPEND scripts ${documents}/kerfline.${shell})
  add_custom_command(OUTPUT ${documents}/kerfline.${shell}
    COMMAND kerfline completion ${shell} > ${documents}/kerfline.${shell}
    DEPENDS kerfline VERBATIM)
endforeach()
add_custom_command(OUTPUT ${documents}/kerfline.1
  COMMAND kerfline manual > ${documents}/kerfline.1
  DEPENDS kerfline VERBATIM)
add_custom_target(kerfline_documents ALL DEPENDS ${documents}/kerfline.1 ${scripts})

install(TARGETS kerfline RUNTIME COMPONENT program)
install(FILES ${documents}/kerfline.1
  DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${documents}/kerfline.bash
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  RENAME kerfline COMPONENT program)
install(FILES ${documents}/kerfline.fish
  DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)
install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/examples
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program
  FILES_MATCHING PATTERN *.nc PATTERN *.settings PATTERN *.svg PATTERN cncrc.json PATTERN README.md
  PATTERN generator EXCLUDE)
install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/machines
  DESTINATION ${CMAKE_INSTALL_DATADIR}/kerfline COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)

# zsh of Debian looks for the scripts of packages and of /usr/local in different folders, and
# Debian knows a licence by another name.
set(zsh ${CMAKE_INSTALL_DATADIR}/zsh)
install(FILES ${documents}/kerfline.zsh
  DESTINATION ${zsh}/site-functions RENAME _kerfline COMPONENT program_elsewhere)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program_elsewhere)
install(FILES ${documents}/kerfline.zsh
  DESTINATION ${zsh}/vendor-completions RENAME _kerfline COMPONENT debian EXCLUDE_FROM_ALL)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE
  DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT debian EXCLUDE_FROM_ALL)
