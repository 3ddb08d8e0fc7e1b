# `cpack` in the build folder makes kerfline_VERSION_ARCHITECTURE.deb of the components `program`
# and `debian`; dpkg-shlibdeps finds the libraries on which it depends.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME kerfline)
set(CPACK_PACKAGE_CONTACT "The Kerfline authors <authors@kerfline.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "controller for laser cutters and mills, simulated")
set(CPACK_PACKAGE_DESCRIPTION
  "Kerfline is a CNC controller for laser cutters and mills. This package has its program for
Linux: a simulator that runs the controller itself and measures its step pulses, a server for
G-code senders and browsers, a sender, and the path from a drawing to a program that knows how
wide the beam cuts.")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_CMAKE_PROJECTS
  "${PROJECT_BINARY_DIR};kerfline;program;/;${PROJECT_BINARY_DIR};kerfline;debian;/")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS fonts-dejavu-core)  # Font of the text in pictures.

# The version with the commit is known only after the build.
get_target_property(CPACK_KERFLINE_VERSION_FILE kerfline_firmware KERFLINE_VERSION_FILE)
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/toolchain/package_version.cmake)
include(CPack)
