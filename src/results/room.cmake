include(${CMAKE_CURRENT_LIST_DIR}/picture.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/report.cmake)
target_link_libraries(cleave_results ${scope} hdf5::hdf5 nlohmann_json::nlohmann_json)
