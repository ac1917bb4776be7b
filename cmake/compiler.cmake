# Flags every target gets. Reasons stand beside the unusual ones.
add_library(cleave_flags INTERFACE)
target_compile_options(cleave_flags INTERFACE
  -Wall -Wextra -Wshadow -Wno-psabi          # psabi: lanes are passed by value, all callers are ours
  -ffp-contract=off                          # same bits from lanes, scalars and every compiler setting
  -fno-math-errno -fno-trapping-math)        # neither changes a result; both free the vectoriser
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # Warnings are errors with the compiler the project is built with; Clang speaks through `./x check`.
  # GCC 12 takes its own AVX-512 headers for uses of uninitialised values (its bug 105593).
  target_compile_options(cleave_flags INTERFACE -Werror -Wno-uninitialized -Wno-maybe-uninitialized)
else()
  # A mask of lanes has no && and ||; with a plain double in its place the same line joins two bools by & and |.
  target_compile_options(cleave_flags INTERFACE -Wno-bitwise-instead-of-logical)
endif()
if(CLEAVE_ARCH)
  target_compile_options(cleave_flags INTERFACE -march=${CLEAVE_ARCH})
endif()
target_include_directories(cleave_flags INTERFACE ${CMAKE_SOURCE_DIR}/src ${CMAKE_BINARY_DIR}/generated)

if(CLEAVE_SANITIZE)
  target_compile_options(cleave_flags INTERFACE -fsanitize=${CLEAVE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(cleave_flags INTERFACE -fsanitize=${CLEAVE_SANITIZE})
endif()
if(CLEAVE_FUZZ)  # coverage feedback in the libraries; the fuzz programs themselves link libFuzzer
  target_compile_options(cleave_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(CLEAVE_COVERAGE)
  target_compile_options(cleave_flags INTERFACE --coverage)
  target_link_options(cleave_flags INTERFACE --coverage)
endif()

set(CMAKE_CXX_FLAGS_RELEASE "-O2 -g1")         # asserts stay on: CLEAVE_ASSERT is not NDEBUG's
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O1 -g1")  # for the sanitizers: quick to build, readable traces
set(CMAKE_CXX_FLAGS_DEBUG "-Og -g")            # not -O0: xsimd 8.1 does not compile for AVX-512 without optimisation

find_program(CLEAVE_CCACHE ccache)
if(CLEAVE_CCACHE)
  # Paths relative to the sources: checkouts at different places share what they compiled.
  set(CMAKE_CXX_COMPILER_LAUNCHER
    ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${CLEAVE_CCACHE})
endif()
find_program(CLEAVE_MOLD mold)
if(CLEAVE_MOLD)
  target_link_options(cleave_flags INTERFACE -fuse-ld=mold)
endif()
