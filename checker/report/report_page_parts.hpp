/// @file
/// The template and the style of the report page. They are part of the program, so that it works wherever it is copied
/// and never meets a template of another age.
#pragma once

namespace workbook {

extern const char* const report_page_template;  ///< report_page.html, for Mustache
extern const char* const report_page_style;     ///< report_page.css

}  // namespace workbook
