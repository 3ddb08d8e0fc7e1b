# Included by cpack. The version of the package is that of its program, without hyphens, because a
# hyphen would begin Debian's own revision.
file(STRINGS ${CPACK_KERFLINE_VERSION_FILE} CPACK_PACKAGE_VERSION)
string(REPLACE - + CPACK_PACKAGE_VERSION ${CPACK_PACKAGE_VERSION})
set(CPACK_DEBIAN_PACKAGE_VERSION ${CPACK_PACKAGE_VERSION})
