target_link_libraries(cleave_base ${scope} TBB::tbb fmt::fmt)
