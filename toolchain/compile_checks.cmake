# Compiles code with the controller's compiler that otherwise only tests would compile. Each header
# is compiled alone, by a source of one line with its layer's flags. The complete controller on a
# bare port instantiates the templates.
option(KERFLINE_HEADERS_ALONE "Compile every header on its own" ON)

function(kerfline_headers_alone layer folder)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
    ${PROJECT_SOURCE_DIR}/${folder}/*.hpp)
  list(FILTER headers EXCLUDE REGEX "/target/")
  set(sources)
  foreach(header IN LISTS headers)
    set(source ${PROJECT_BINARY_DIR}/headers_alone/${header}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "#include \"@header@\"\n" @ONLY)
    list(APPEND sources ${source})
  endforeach()
  if(sources)
    get_target_property(flags ${layer} KERFLINE_FLAGS)
    if(NOT flags)
      set(flags kerfline_controller_flags)
    endif()
    add_library(${layer}_headers_alone OBJECT EXCLUDE_FROM_ALL ${sources})
    add_dependencies(headers_alone ${layer}_headers_alone)
    set_target_properties(${layer}_headers_alone PROPERTIES UNITY_BUILD OFF)
    target_link_libraries(${layer}_headers_alone PRIVATE ${flags} ${layer})
    if(KERFLINE_HOST)
      target_compile_options(${layer}_headers_alone PRIVATE -O0)  # Little to optimise.
    endif()
  endif()
endfunction()

function(kerfline_compile_checks)
  if(NOT KERFLINE_HEADERS_ALONE)
    return()
  endif()
  add_custom_target(headers_alone)
  # Only the controller's own compiler compiles its headers; once is enough.
  if(KERFLINE_HOST)
    kerfline_headers_alone(kerfline_hal_host hal/host)
    kerfline_headers_alone(kerfline_hal_stm32f405 hal/stm32f405)  # For clang-tidy.
    kerfline_headers_alone(kerfline_cam host-sim)
  else()
    kerfline_headers_alone(kerfline_hal_interface hal/interface)
    kerfline_headers_alone(kerfline_hal_stm32f405 hal/stm32f405)
    kerfline_headers_alone(kerfline_planner planner)
    kerfline_headers_alone(kerfline_firmware firmware)
    add_library(bare_controller OBJECT ${PROJECT_SOURCE_DIR}/tests/static/bare_controller.cpp)
    target_link_libraries(bare_controller PRIVATE kerfline_controller_flags kerfline_firmware)
  endif()
endfunction()

# At the end of the top CMakeLists.txt, when every layer is known.
cmake_language(DEFER DIRECTORY ${PROJECT_SOURCE_DIR} CALL kerfline_compile_checks)
