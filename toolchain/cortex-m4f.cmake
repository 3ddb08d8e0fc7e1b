# The controller's compiler: STM32F405 class, Cortex-M4 with a single-precision
# FPU, no operating system.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

# Not -ffreestanding: newlib is there, and its freestanding mode would turn
# memcpy and sqrtf, which are a few instructions each, into calls.
# -fno-schedule-insns: moved apart before registers are given out, instructions need more of
# those than there are; without, 2 % of the code and of what a segment costs are saved.
# -fcallgraph-info writes every function's stack frame and calls beside its
# object; tests/static/cortex_gates.py reads them.
string(JOIN " " CMAKE_CXX_FLAGS_INIT
  -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard
  -ffunction-sections -fdata-sections -fno-schedule-insns
  -fno-unwind-tables -fno-asynchronous-unwind-tables -fno-use-cxa-atexit
  -fcallgraph-info=su,da
  -DEIGEN_NO_IO)

# Headers of the host's Eigen, nothing else of the host.
set(Eigen3_DIR /usr/share/eigen3/cmake)
