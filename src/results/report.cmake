# The page of `cleave view`: its HTML, CSS and JavaScript become strings of the program, so that the program finds
# them wherever it is installed. Scripts are joined in the order of this list.
set(page_folder ${CMAKE_SOURCE_DIR}/report)
set(page_scripts third_party/uplot/uPlot.iife.min.js data.js charts.js histories.js mesh.js viewer.js profiles.js page.js)
set(page_styles third_party/uplot/uPlot.min.css style.css)

function(cleave_join out)
  set(text "")
  foreach(name ${ARGN})
    file(READ ${page_folder}/${name} content)
    string(APPEND text "${content}\n")
    set_property(DIRECTORY ${CMAKE_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page_folder}/${name})
  endforeach()
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

cleave_join(html page.html)
cleave_join(style ${page_styles})
cleave_join(script ${page_scripts})
configure_file(${CMAKE_CURRENT_LIST_DIR}/report_page.cpp.in ${CMAKE_BINARY_DIR}/generated/report_page.cpp @ONLY)
target_sources(cleave_results PRIVATE ${CMAKE_BINARY_DIR}/generated/report_page.cpp)
