/// @file
/// Pages and files for other programs, made from templates of mustache: report/pages and grading/forms.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace workbook {

/// The template of mustache with that name, or what else a page holds. They are part of the program, which then works
/// wherever it is copied and never meets a template of another version.
const std::string& page_template(const std::string& name);

/// A page made from a template. All text of the document is text on the page, without control characters.
/// @param raw  what the template takes unescaped, by name. @throws std::logic_error if it is no template
std::string rendered_page(const std::string& page_template, const nlohmann::json& document,
                          const std::map<std::string, std::string>& raw = {});
/// The same for other files: text is escaped as JSON has it in strings, but for XML where the file's name says so.
/// @param templates  by the names of the files
std::map<std::filesystem::path, std::string> filled_texts(const std::map<std::filesystem::path, std::string>& templates,
                                                          const nlohmann::json& values);
/// Those of page_template() with these names.
std::map<std::filesystem::path, std::string> filled_forms(const std::vector<const char*>& names,
                                                          const nlohmann::json& values);

}  // namespace workbook
