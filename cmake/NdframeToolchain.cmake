# Compiler settings shared by all packages: warnings, sanitizers, ccache and lld where the machine has them.

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(NDFRAME_CCACHE ccache)
if(NDFRAME_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${NDFRAME_CCACHE})
endif()

find_program(NDFRAME_LLD ld.lld)

add_library(ndframe_options INTERFACE)
target_compile_options(ndframe_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
if(NDFRAME_LLD)
  target_link_options(ndframe_options INTERFACE -fuse-ld=lld)
  # lld 14 keeps the empty unwind entry of an empty .cold partition of g++ 12: a throw there would abort.
  target_compile_options(ndframe_options INTERFACE -fno-reorder-blocks-and-partition)
endif()
if(NDFRAME_SANITIZE)
  # A null pointer or the end of an object is an address that the address sanitizer sees; checks of them before every
  # access double the compiler's time. Checks of the type behind a base class take a fifth of it, for a dozen casts.
  target_compile_options(ndframe_options INTERFACE
    -fsanitize=address -fno-omit-frame-pointer
    "$<$<NOT:$<BOOL:$<TARGET_PROPERTY:NDFRAME_IS_TEST>>>:-fsanitize=undefined;-fno-sanitize=null,alignment,object-size,vptr;-fno-sanitize-recover=undefined>")
  # The sanitizer calls dlopen in our stead, and only the old kind of path holds for callers that are not the program.
  target_link_options(ndframe_options INTERFACE -fsanitize=address,undefined LINKER:--disable-new-dtags)
endif()
