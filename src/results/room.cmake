include(${CMAKE_CURRENT_LIST_DIR}/picture.cmake)
