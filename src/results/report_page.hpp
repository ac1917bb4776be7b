#pragma once
/// The page's own sources (report/ at the top of the project), compiled in by report.cmake.

#include <string_view>

namespace cleave::results {

std::string_view page_html();    ///< with comments where style, data and script go
std::string_view page_style();   ///< CSS
std::string_view page_script();  ///< JavaScript: the chart library, then the page's own files

}  // namespace cleave::results
