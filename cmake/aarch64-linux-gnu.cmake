# Compiles for 64-bit ARM on another machine, with Debian's cross compiler: cmake --toolchain cmake/aarch64-linux-gnu.cmake
# Libraries are those of Debian's architecture arm64, programs that the build runs those of the machine that it runs on; the
# project's own among them is named by MLAB_CNLC (cmake/MlabProcedures.cmake).

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE arm64)
