# Flags every target gets. Reasons stand beside the unusual ones.
add_library(cleave_flags INTERFACE)
target_compile_options(cleave_flags INTERFACE
  -Wall -Wextra -Werror -Wshadow -Wno-psabi  # psabi: lanes are passed by value, all callers are ours
  -ffp-contract=off                          # same bits from lanes, scalars and every compiler setting
  -fno-math-errno -fno-trapping-math)        # neither changes a result; both free the vectoriser
# GCC 12 takes its own AVX-512 headers for uses of uninitialised values (its bug 105593).
target_compile_options(cleave_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized$<SEMICOLON>-Wno-maybe-uninitialized>)
if(CLEAVE_ARCH)
  target_compile_options(cleave_flags INTERFACE -march=${CLEAVE_ARCH})
endif()
target_include_directories(cleave_flags INTERFACE ${CMAKE_SOURCE_DIR}/src ${CMAKE_BINARY_DIR}/generated)

if(CLEAVE_SANITIZE)
  target_compile_options(cleave_flags INTERFACE -fsanitize=${CLEAVE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(cleave_flags INTERFACE -fsanitize=${CLEAVE_SANITIZE})
endif()

set(CMAKE_CXX_FLAGS_RELEASE "-O2 -g1")       # asserts stay on: CLEAVE_ASSERT is not NDEBUG's

find_program(CLEAVE_CCACHE ccache)
if(CLEAVE_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CLEAVE_CCACHE})
endif()
find_program(CLEAVE_MOLD mold)
if(CLEAVE_MOLD)
  target_link_options(cleave_flags INTERFACE -fuse-ld=mold)
endif()
