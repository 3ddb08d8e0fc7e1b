# What `find_package(kerfline)` of another project finds: the library, its headers under
# include/kerfline, and the target kerfline::planner. Component `planner`.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/kerfline)
install(TARGETS kerfline_planner kerfline_same_bits kerfline_contract_handler
  EXPORT kerfline-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT planner)
install(DIRECTORY ${CMAKE_CURRENT_LIST_DIR}/ DESTINATION include/kerfline/planner
  COMPONENT planner FILES_MATCHING PATTERN "*.hpp" PATTERN "examples" EXCLUDE)
install(EXPORT kerfline-targets NAMESPACE kerfline:: DESTINATION ${package} COMPONENT planner)

# Before version 1 a new minor version may change the interface.
set(version_file ${PROJECT_BINARY_DIR}/kerfline-config-version.cmake)
write_basic_package_version_file(${version_file} COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/kerfline-config.cmake ${version_file}
  DESTINATION ${package} COMPONENT planner)
