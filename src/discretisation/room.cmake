# The element kernels are long straight lines of lanes: full unrolling and inlining keep them in registers.
target_compile_options(cleave_discretisation PRIVATE -O3)
