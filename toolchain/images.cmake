# An image for each board: .elf, .bin, .hex and .dfu in build/cortex-m4f/images, with sizes, check
# sums and the command that flashes it.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

set(KERFLINE_STACK_BYTES 8192 CACHE STRING "Stack of the images, its guard included")

# kerfline_board_image(NAME HEADER OBJECT OFFSET_KIB END_KIB): the board OBJECT of
# hal/stm32f405/boards/HEADER.hpp, from and to these places in the flash.
function(kerfline_board_image name header object offset_kib end_kib)
  math(EXPR begin "0x08000000 + ${offset_kib} * 1024" OUTPUT_FORMAT HEXADECIMAL)
  math(EXPR end "0x08000000 + ${end_kib} * 1024" OUTPUT_FORMAT HEXADECIMAL)
  set(script ${PROJECT_SOURCE_DIR}/toolchain/stm32f405.ld)
  set(folder ${PROJECT_BINARY_DIR}/images)
  set(main ${PROJECT_SOURCE_DIR}/firmware/target/stm32f405_main.cpp)
  # The fast one first: of inline functions that both have, the linker takes the first.
  add_executable(${name} ${PROJECT_SOURCE_DIR}/firmware/target/stm32f405_steps.cpp
    ${PROJECT_SOURCE_DIR}/firmware/target/stm32f405_conversions.cpp
    $<TARGET_OBJECTS:kerfline_planner> ${main})
  set_source_files_properties(${main} PROPERTIES COMPILE_OPTIONS -Os)
  set_target_properties(${name} PROPERTIES
    SUFFIX .elf RUNTIME_OUTPUT_DIRECTORY ${folder} LINK_DEPENDS ${script})
  target_compile_definitions(${name} PRIVATE
    KERFLINE_BOARD_HEADER="hal/stm32f405/boards/${header}.hpp" KERFLINE_BOARD=${object})
  target_link_libraries(${name} PRIVATE
    kerfline_controller_flags kerfline_firmware kerfline_hal_stm32f405)
  target_link_options(${name} PRIVATE
    -nostartfiles --specs=nano.specs -Wl,--gc-sections -T${script}
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

# Where the board's boot loader leaves off, and where its store begins or 256 KiB are full.
kerfline_board_image(kerfline_generic generic ${generic_${KERFLINE_GENERIC_CRYSTAL}} 0 256)
kerfline_board_image(kerfline_generic_1mbaud generic kGeneric1MBaud 0 256)
kerfline_board_image(kerfline_btt_skr_2 btt_skr_2 kBttSkr2 32 288)
kerfline_board_image(kerfline_btt_skr_pro_1_2 btt_skr_pro_1_2 kBttSkrPro12 32 288)
kerfline_board_image(kerfline_mks_robin_nano_v3 mks_robin_nano_v3 kMksRobinNanoV3 48 256)
