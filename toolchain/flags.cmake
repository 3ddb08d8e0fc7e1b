# Flags that every target shares. What decides motion must give the same bits on
# every machine, so no contraction of a*b+c and no vector code in Eigen.
add_library(kerfline_flags INTERFACE)
target_include_directories(kerfline_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(kerfline_flags INTERFACE
  -Wall -Wextra -Wconversion -Wshadow -Werror -ffp-contract=off -fno-math-errno
  -ffile-prefix-map=${PROJECT_SOURCE_DIR}/=)  # The same image from any folder.
target_compile_definitions(kerfline_flags INTERFACE
  EIGEN_DONT_VECTORIZE EIGEN_NO_MALLOC EIGEN_NO_DEBUG EIGEN_STACK_ALLOCATION_LIMIT=1024
  EIGEN_MAX_STATIC_ALIGN_BYTES=0)
if(KERFLINE_HOST AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # False alarms of GCC 12 inside std::string (GCC bugs 105329, 105651). The
  # controller's build, which has no std::string, keeps these warnings.
  target_compile_options(kerfline_flags INTERFACE
    -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  # The sanitized builds. Its warnings are judged by clang-tidy.
  target_compile_options(kerfline_flags INTERFACE -Wno-error)
endif()

# What runs on the controller: also no exceptions, no RTTI, no silent doubles.
add_library(kerfline_controller_flags INTERFACE)
target_link_libraries(kerfline_controller_flags INTERFACE kerfline_flags)
target_compile_options(kerfline_controller_flags INTERFACE
  -fno-exceptions -fno-rtti -fno-threadsafe-statics -Wdouble-promotion -Wvla
  $<$<CXX_COMPILER_ID:GNU>:-Wno-psabi>)  # All of it is built by one compiler.

option(KERFLINE_SANITIZE "AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
if(KERFLINE_SANITIZE)
  # The vptr check compares type infos, which code built without RTTI has not.
  set(sanitizers -fsanitize=address,undefined -fno-sanitize=vptr)
  add_compile_options(${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(${sanitizers})
endif()

option(KERFLINE_FUZZ "libFuzzer programs of tests/fuzz; needs Clang" OFF)
if(KERFLINE_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
  add_link_options(-fsanitize=fuzzer-no-link)
endif()

find_package(Eigen3 3.4 REQUIRED NO_MODULE)

# Every .cpp below a layer's folder belongs to the layer.
function(kerfline_layer name flags)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/target/|/examples/|/main\\.cpp$")
  if(sources)
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PRIVATE ${flags} PUBLIC kerfline_flags ${ARGN})
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE kerfline_flags ${ARGN})
  endif()
  set_target_properties(${name} PROPERTIES KERFLINE_FLAGS ${flags})
endfunction()

include(toolchain/compile_checks.cmake)
