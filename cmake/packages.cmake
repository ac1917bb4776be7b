# Every outside library, in one place, with the Debian package it comes from. `./x setup` installs these
# packages and docs/dependencies.md says why each is here; tools/check_layers.py keeps the three in step.
find_package(TBB REQUIRED)             # apt: libtbb-dev
find_package(fmt REQUIRED)             # apt: libfmt-dev
find_package(HDF5 REQUIRED COMPONENTS C)  # apt: libhdf5-dev
find_package(CLI11 REQUIRED)           # apt: libcli11-dev
find_package(nlohmann_json REQUIRED)   # apt: nlohmann-json3-dev
find_package(Python3 REQUIRED COMPONENTS Interpreter)  # apt: python3
