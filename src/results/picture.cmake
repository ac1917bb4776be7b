# cairo draws the text of pictures and writes PNG files; only picture.cpp includes it.
find_path(CLEAVE_CAIRO_INCLUDE cairo.h PATH_SUFFIXES cairo REQUIRED)  # apt: libcairo2-dev
find_library(CLEAVE_CAIRO cairo REQUIRED)
target_include_directories(cleave_results SYSTEM ${scope} ${CLEAVE_CAIRO_INCLUDE})
target_link_libraries(cleave_results ${scope} ${CLEAVE_CAIRO})
