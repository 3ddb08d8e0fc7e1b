# The controller's compiler: STM32F405 class, Cortex-M4 with a single-precision
# FPU, no operating system.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

# Without -ffreestanding: newlib is available, and in freestanding mode the compiler would call
# memcpy and sqrtf instead of inserting their few instructions.
# -fno-schedule-insns: this pass moves instructions apart before registers are allocated, which
# requires more registers than the core has. Without it the code is smaller, and a line of G-code
# and the step interrupt cost fewer instructions (tests/target/instructions.py).
# -fno-devirtualize-speculatively: a guess at the function that a virtual call reaches takes the
# address of that function, which may be of a class that the image does not use; tests/static/
# image_stack.py could not tell it from a call by pointer.
# -fcallgraph-info writes every function's stack frame and calls to a file next to the object;
# tests/static/cortex_gates.py reads it.
string(JOIN " " CMAKE_CXX_FLAGS_INIT
  -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard
  -ffunction-sections -fdata-sections -fno-schedule-insns -fno-devirtualize-speculatively
  -fno-unwind-tables -fno-asynchronous-unwind-tables -fno-use-cxa-atexit
  -fcallgraph-info=su,da
  -DEIGEN_NO_IO)

# Of the host's headers, only those of Eigen are used.
set(Eigen3_DIR /usr/share/eigen3/cmake)
