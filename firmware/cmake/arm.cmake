# Images and checks for Cortex-M4: configure with -DCMAKE_TOOLCHAIN_FILE=cmake/arm-none-eabi.cmake.
set(qemu_dir "${CMAKE_CURRENT_SOURCE_DIR}/boards/qemu_m4")

add_executable(reliefscope_qemu_m4 ${core_sources}
  boards/qemu_m4/main.cpp boards/qemu_m4/startup.cpp)
reliefscope_settings(reliefscope_qemu_m4)
target_compile_options(reliefscope_qemu_m4 PRIVATE -Os -ffreestanding)
target_link_options(reliefscope_qemu_m4 PRIVATE
  -nostartfiles --specs=nosys.specs -T "${qemu_dir}/image.ld")
set_target_properties(reliefscope_qemu_m4 PROPERTIES
  SUFFIX .elf LINK_DEPENDS "${qemu_dir}/image.ld")

# The unit tests as ARM code.
set(tests_dir "${CMAKE_CURRENT_SOURCE_DIR}/../tests/firmware")
file(GLOB test_sources CONFIGURE_DEPENDS "${tests_dir}/*.cpp")
add_executable(reliefscope_qemu_tests ${core_sources} ${test_sources}
  boards/qemu_m4/tests_vectors.cpp)
reliefscope_settings(reliefscope_qemu_tests)
set_target_properties(reliefscope_qemu_tests PROPERTIES
  SUFFIX .elf CXX_EXTENSIONS ON LINK_DEPENDS "${qemu_dir}/tests.ld")
target_include_directories(reliefscope_qemu_tests PRIVATE
  "${tests_dir}" "${CMAKE_CURRENT_SOURCE_DIR}/core")
target_compile_options(reliefscope_qemu_tests PRIVATE -Os)
target_link_options(reliefscope_qemu_tests PRIVATE --specs=rdimon.specs -T "${qemu_dir}/tests.ld")

# The Teensy's port, compiled and not linked: the stubs declare what it uses of the Teensy core,
# which PlatformIO brings where its registry is in reach. Flags as that platform's.
add_library(reliefscope_teensy31_check OBJECT ${core_sources}
  boards/teensy31/board.cpp boards/teensy31/leds.cpp)
reliefscope_settings(reliefscope_teensy31_check)
set_target_properties(reliefscope_teensy31_check PROPERTIES CXX_EXTENSIONS ON)
target_include_directories(reliefscope_teensy31_check SYSTEM PRIVATE boards/teensy31/stubs)
target_compile_options(reliefscope_teensy31_check PRIVATE
  -O2 -fsingle-precision-constant -mno-unaligned-access)
