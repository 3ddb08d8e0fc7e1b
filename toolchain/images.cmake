# An image for each board: .elf, .bin, .hex and .dfu in build/cortex-m4f/images, with sizes, check
# sums and the command that flashes it.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

set(KERFLINE_STACK_BYTES 8192 CACHE STRING "Stack of the images, above its guard")

# The layers again, compiled for size. Only these are optimized at link time, which makes the image
# a sixteenth smaller; otherwise MKS Robin Nano V3.1 would lack functions that other boards have.
# Frames are bounded: across files the compiler would merge the frames of a function and of the
# functions that it calls, until the main loop needed too much stack. Code that recomputes a value
# in each pass of a loop is shorter than code that keeps the value.
set(small_flags -Os -flto -fno-inline-small-functions -fno-tree-loop-im -fno-move-loop-invariants
  -fno-tree-ch -fno-reorder-blocks
  --param=large-stack-frame=200 --param=large-stack-frame-growth=50)
function(kerfline_small_layer name)
  get_target_property(sources ${name} SOURCES)
  list(FILTER sources EXCLUDE REGEX "/version\\.cpp$")
  foreach(source ${sources})
    get_source_file_property(skipped ${source} TARGET_DIRECTORY ${name} HEADER_FILE_ONLY)
    if(skipped)
      list(REMOVE_ITEM sources ${source})
    endif()
    get_source_file_property(alone ${source} TARGET_DIRECTORY ${name} SKIP_UNITY_BUILD_INCLUSION)
    if(alone)
      set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
  get_target_property(flags ${name} KERFLINE_FLAGS)
  add_library(${name}_small STATIC EXCLUDE_FROM_ALL ${sources})
  target_link_libraries(${name}_small PRIVATE ${flags} PUBLIC ${ARGN})
  target_compile_options(${name}_small PRIVATE ${small_flags} -ffat-lto-objects)
  get_target_property(dependencies ${name} MANUALLY_ADDED_DEPENDENCIES)
  if(dependencies)
    add_dependencies(${name}_small ${dependencies})
  endif()
endfunction()
kerfline_small_layer(kerfline_planner kerfline_flags Eigen3::Eigen)
kerfline_small_layer(kerfline_firmware kerfline_flags kerfline_planner_small kerfline_hal_interface)
target_compile_definitions(kerfline_planner_small PUBLIC KERFLINE_FIVE_AXES=0)
target_compile_definitions(kerfline_firmware_small PUBLIC KERFLINE_SETTING_HELP=0)
kerfline_add_version(kerfline_firmware_small)

# The step interrupt is compiled for speed on every board.
set(target ${PROJECT_SOURCE_DIR}/firmware/target)
set(steps ${target}/stm32f405_steps.cpp)
set_source_files_properties(${steps} PROPERTIES COMPILE_OPTIONS -O2)

# kerfline_board_image(NAME HEADER OBJECT OFFSET_KIB END_KIB [SMALL]): the board OBJECT of
# hal/stm32f405/boards/HEADER.hpp, from and to these addresses of the flash; SMALL compiles
# everything but the step interrupt for size.
function(kerfline_board_image name header object offset_kib end_kib)
  cmake_parse_arguments(PARSE_ARGV 5 image "SMALL" "" "")
  math(EXPR begin "0x08000000 + ${offset_kib} * 1024" OUTPUT_FORMAT HEXADECIMAL)
  math(EXPR end "0x08000000 + ${end_kib} * 1024" OUTPUT_FORMAT HEXADECIMAL)
  set(script ${PROJECT_SOURCE_DIR}/toolchain/stm32f405.ld)
  set(folder ${PROJECT_BINARY_DIR}/images)
  add_executable(${name} ${steps} ${target}/stm32f405_main.cpp ${target}/stm32f405_start.cpp
    ${target}/stm32f405_ends.cpp ${target}/stm32f405_caution.cpp)
  if(image_SMALL)
    target_compile_options(${name} PRIVATE -Os)
    target_link_options(${name} PRIVATE ${small_flags} -flto-partition=one)
    set(firmware kerfline_firmware_small)
  else()
    set(firmware kerfline_firmware)
  endif()
  set_target_properties(${name} PROPERTIES
    UNITY_BUILD OFF SUFFIX .elf RUNTIME_OUTPUT_DIRECTORY ${folder} LINK_DEPENDS ${script})
  target_compile_definitions(${name} PRIVATE
    KERFLINE_BOARD_HEADER="hal/stm32f405/boards/${header}.hpp" KERFLINE_BOARD=${object})
  target_link_libraries(${name} PRIVATE
    kerfline_controller_flags ${firmware} kerfline_hal_stm32f405)
  target_link_options(${name} PRIVATE
    -nostartfiles --specs=nano.specs -Wl,--gc-sections -T${script}
    -Wl,--emit-relocs  # For image_stack.py; binary files contain no relocations.
    -Wl,--defsym=application_begin=${begin} -Wl,--defsym=application_end=${end}
    -Wl,--defsym=stack_bytes=${KERFLINE_STACK_BYTES})
  add_custom_command(TARGET ${name} POST_BUILD
    COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/toolchain/image_files.py
      $<TARGET_FILE:${name}> ${begin})
endfunction()

set(KERFLINE_GENERIC_CRYSTAL 8 CACHE STRING "Crystal of the generic board in MHz")
set_property(CACHE KERFLINE_GENERIC_CRYSTAL PROPERTY STRINGS 8 12 25)
set(generic_8 kGeneric)
set(generic_12 kGeneric12)
set(generic_25 kGeneric25)
if(NOT DEFINED generic_${KERFLINE_GENERIC_CRYSTAL})
  message(FATAL_ERROR "KERFLINE_GENERIC_CRYSTAL is 8, 12 or 25, not ${KERFLINE_GENERIC_CRYSTAL}")
endif()

set(KERFLINE_ROBIN_NANO_BEAM 3D-TOUCH CACHE STRING
  "Connector of the beam on MKS Robin Nano V3: 3D-TOUCH, or the TTL header of HE1")
set_property(CACHE KERFLINE_ROBIN_NANO_BEAM PROPERTY STRINGS 3D-TOUCH HE1)
set(beam_3D-TOUCH "")
set(beam_HE1 He1)
if(NOT DEFINED beam_${KERFLINE_ROBIN_NANO_BEAM})
  message(FATAL_ERROR
    "KERFLINE_ROBIN_NANO_BEAM is 3D-TOUCH or HE1, not ${KERFLINE_ROBIN_NANO_BEAM}")
endif()
set(beam ${beam_${KERFLINE_ROBIN_NANO_BEAM}})

# Each image extends from the end of the board's boot loader to the beginning of the store on the
# largest chip of the board: sector 10 with 1 MiB, sector 6 with 512 KiB. kerfline_generic_512 runs
# on both chips and detects the chip at start; so do images that end at 768 KiB, if they fit.
set(generic ${generic_${KERFLINE_GENERIC_CRYSTAL}})
kerfline_board_image(kerfline_generic generic ${generic} 0 768)
kerfline_board_image(kerfline_generic_512 generic ${generic} 0 256 SMALL)
kerfline_board_image(kerfline_generic_can generic kGenericCan 0 768)
kerfline_board_image(kerfline_generic_1mbaud generic kGeneric1MBaud 0 768)
kerfline_board_image(kerfline_btt_skr_2 btt_skr_2 kBttSkr2 32 768)
kerfline_board_image(kerfline_btt_skr_pro_1_2 btt_skr_pro_1_2 kBttSkrPro12 32 768)
kerfline_board_image(kerfline_mks_robin_nano_v3_0 mks_robin_nano_v3
  kMksRobinNanoV30${beam} 48 768)
kerfline_board_image(kerfline_mks_robin_nano_v3_1 mks_robin_nano_v3
  kMksRobinNanoV31${beam} 48 256 SMALL)
