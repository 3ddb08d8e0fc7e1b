# kerfline_add_version(TARGET): adds the definition of cnc::identity::version() to TARGET. The
# version is determined at each build, and only a new version compiles: one source of one line.
function(kerfline_add_version target)
  set(version ${CMAKE_CURRENT_BINARY_DIR}/version)
  add_custom_target(${target}_version
    COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DVERSION=${PROJECT_VERSION}
      -DOUTPUT=${version} -P ${PROJECT_SOURCE_DIR}/toolchain/write_version.cmake
    BYPRODUCTS ${version}.cpp ${version}.txt COMMENT "Determining the version" VERBATIM)
  target_sources(${target} PRIVATE ${version}.cpp)
  set_source_files_properties(${version}.cpp PROPERTIES
    GENERATED ON SKIP_UNITY_BUILD_INCLUSION ON)
  add_dependencies(${target} ${target}_version)
  set_target_properties(${target} PROPERTIES KERFLINE_VERSION_FILE ${version}.txt)
endfunction()
