# A cross build for aarch64 with Debian's g++-aarch64-linux-gnu; qemu-user runs what comes out. It finds headers only:
# GoogleTest is built from its sources, and what needs other libraries is left out (see the preset).
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)  # which GoogleTest asks for
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L /usr/aarch64-linux-gnu)
# Boost's headers are for any machine, but what describes them is in the folder of this one's libraries.
set(CMAKE_PREFIX_PATH /usr/lib/${CMAKE_HOST_SYSTEM_PROCESSOR}-linux-gnu/cmake)
