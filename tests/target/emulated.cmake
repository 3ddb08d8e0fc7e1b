# Tests of the images in the emulator. They run in the release build, because the emulator cannot
# load a sanitizer's run-time library.
#
# instructions: a program for the chip alone, which counts the cost of each stage.
# controller, dark_first: the unchanged images of the controller.
# image_trace: compares the controller's image with the simulator, edge by edge.
set(images ${PROJECT_SOURCE_DIR}/build/cortex-m4f/images)
set(plugin ${PROJECT_BINARY_DIR}/tests/target/machine/f405_machine.so)
add_test(NAME target.instructions
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/instructions.py
    ${plugin} ${PROJECT_SOURCE_DIR}/build/cortex-m4f/tests/target/instructions.elf)
add_test(NAME target.same_bits
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/same_bits.py
    $<TARGET_FILE:same_bits_host>
    ${plugin} ${PROJECT_SOURCE_DIR}/build/cortex-m4f/tests/target/same_bits.elf)
set_tests_properties(target.instructions target.same_bits PROPERTIES
  LABELS target TIMEOUT 300 SKIP_RETURN_CODE 77)
add_test(NAME target.controller
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/controller.py
    ${plugin} ${images}/kerfline_generic.elf)
add_test(NAME target.dark_first
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/dark_first.py
    ${plugin} ${images}/kerfline_generic.elf=A8 ${images}/kerfline_generic_512.elf=A8
    ${images}/kerfline_generic_can.elf=A8 ${images}/kerfline_btt_skr_2.elf=B0
    ${images}/kerfline_btt_skr_pro_1_2.elf=A8 ${images}/kerfline_mks_robin_nano_v3_0.elf=A8
    ${images}/kerfline_mks_robin_nano_v3_1.elf=A8)
set_tests_properties(target.controller target.dark_first PROPERTIES
  LABELS target TIMEOUT 300 SKIP_RETURN_CODE 77)
# faults: plants faults in the emulated chip with all its peripherals.
foreach(test faults fitness flips cuts job drivers)
  set(image kerfline_generic)
  if(test STREQUAL job)
    set(image kerfline_generic_1mbaud)
  elseif(test MATCHES "fitness|cuts")
    set(image kerfline_generic_512)
  elseif(test STREQUAL drivers)
    set(image kerfline_mks_robin_nano_v3_1)
  endif()
  add_test(NAME target.${test}
    COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/faults/test_${test}.py
      ${plugin} ${images}/${image}.elf)
  set_tests_properties(target.${test} PROPERTIES LABELS target TIMEOUT 300 SKIP_RETURN_CODE 77)
endforeach()
add_test(NAME target.resume
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/faults/test_resume.py
    ${plugin} ${images}/kerfline_generic.elf)
set_tests_properties(target.resume PROPERTIES LABELS target TIMEOUT 300 SKIP_RETURN_CODE 77)
add_test(NAME target.can_image
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/faults/test_can.py
    ${plugin} ${images}/kerfline_generic_can.elf)
set_tests_properties(target.can_image PROPERTIES LABELS target TIMEOUT 300 SKIP_RETURN_CODE 77)
# image_trace: compares every edge of the image with that of the simulator.
file(GLOB trace_sources CONFIGURE_DEPENDS trace/*.cpp)
add_executable(image_trace_jobs ${trace_sources} ../contract_handler.cpp)
target_link_libraries(image_trace_jobs PRIVATE kerfline_test_support)
add_test(NAME target.image_trace
  COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/image_trace.py
    ${plugin} ${images}/kerfline_generic_1mbaud.elf $<TARGET_FILE:image_trace_jobs>
    ${PROJECT_SOURCE_DIR}/host-sim/examples)
set_tests_properties(target.image_trace PROPERTIES
  LABELS target TIMEOUT 600 SKIP_RETURN_CODE 77)
