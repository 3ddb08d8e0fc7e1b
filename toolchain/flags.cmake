# Included by the top folder, or by planner/ if another project uses planner/ alone.
include_guard(GLOBAL)
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH kerfline_root)

option(KERFLINE_HOST "Build for the machine that runs the program, not for a controller" ON)
option(KERFLINE_CONTRACT_TEXT "A failed contract names its condition, file and line"
  ${KERFLINE_HOST})

# Flags that affect results and layouts in headers, so that projects that use the planner require
# them, too. Motion has the same bits on every machine: no contraction of a*b+c, no vector code in
# Eigen.
add_library(kerfline_same_bits INTERFACE)
target_compile_features(kerfline_same_bits INTERFACE cxx_std_20)
target_compile_options(kerfline_same_bits INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off> $<$<COMPILE_LANGUAGE:CXX>:-fno-math-errno>)
target_compile_definitions(kerfline_same_bits INTERFACE
  EIGEN_DONT_VECTORIZE EIGEN_MAX_STATIC_ALIGN_BYTES=0
  KERFLINE_CONTRACT_TEXT=$<BOOL:${KERFLINE_CONTRACT_TEXT}>)

# Flags that every target of this project shares.
add_library(kerfline_flags INTERFACE)
target_link_libraries(kerfline_flags INTERFACE kerfline_same_bits)
target_include_directories(kerfline_flags INTERFACE ${kerfline_root})
target_compile_options(kerfline_flags INTERFACE
  -Wall -Wextra -Wconversion -Wshadow
  -ffile-prefix-map=${kerfline_root}/=)  # Images do not depend on the folder.
target_compile_definitions(kerfline_flags INTERFACE
  EIGEN_NO_MALLOC EIGEN_NO_DEBUG EIGEN_STACK_ALLOCATION_LIMIT=1024)
if(KERFLINE_TOP_LEVEL)
  # Within another project, a warning of a new compiler must not be an error.
  target_compile_options(kerfline_flags INTERFACE -Werror)
endif()
if(KERFLINE_HOST AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # False alarms of GCC 12 inside std::string (GCC bugs 105329, 105651). The
  # controller's build, which has no std::string, keeps these warnings.
  target_compile_options(kerfline_flags INTERFACE
    -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  # Clang makes the sanitized builds; clang-tidy judges its warnings.
  target_compile_options(kerfline_flags INTERFACE -Wno-error)
endif()

# Additional flags of the controller's code: no exceptions, no RTTI, no implicit doubles.
add_library(kerfline_controller_flags INTERFACE)
target_link_libraries(kerfline_controller_flags INTERFACE kerfline_flags)
target_compile_options(kerfline_controller_flags INTERFACE
  -fno-exceptions -fno-rtti -fno-threadsafe-statics -Wdouble-promotion -Wvla
  $<$<CXX_COMPILER_ID:GNU>:-Wno-psabi>)  # One compiler builds all of the code.

option(KERFLINE_SANITIZE "AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
if(KERFLINE_SANITIZE)
  # The vptr check compares type infos, which code without RTTI lacks.
  set(sanitizers -fsanitize=address,undefined -fno-sanitize=vptr)
  add_compile_options(${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(${sanitizers})
endif()

option(KERFLINE_FUZZ "libFuzzer programs of tests/fuzz; needs Clang" OFF)
if(KERFLINE_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link
    -fsanitize-coverage-ignorelist=${CMAKE_CURRENT_LIST_DIR}/not_followed.txt)
  add_link_options(-fsanitize=fuzzer-no-link)
endif()

# Global, because a project that uses planner/ alone links Eigen from its own folder.
find_package(Eigen3 3.4 REQUIRED NO_MODULE GLOBAL)

# Headers that most sources of the host include, and that change only with the system.
set(KERFLINE_LIBRARY_HEADERS <Eigen/Core> <fmt/format.h> <algorithm> <filesystem> <functional>
  <map> <optional> <ranges> <string> <vector>)

# Every .cpp below a layer's folder belongs to the layer.
function(kerfline_sources result)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/target/|/examples/|/main\\.cpp$")
  set(${result} ${sources} PARENT_SCOPE)
endfunction()

function(kerfline_layer name flags)
  kerfline_sources(sources)
  if(sources)
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PRIVATE ${flags} PUBLIC kerfline_flags ${ARGN})
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE kerfline_flags ${ARGN})
  endif()
  set_target_properties(${name} PROPERTIES KERFLINE_FLAGS ${flags})
endfunction()
