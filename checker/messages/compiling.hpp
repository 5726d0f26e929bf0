/// @file
/// Everything that is said to a student about a file that does not compile, or whose text gives a mistake away.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace workbook::messages {

// --- why a file cannot become a program

std::string does_not_compile(int line);  ///< 0: no line of the file is to be named
std::string does_not_compile(const std::string& error);
std::string takes_too_long_to_compile();
std::string takes_too_much_memory_to_compile();
std::string makes_too_large_a_program();
std::string no_room_to_compile();
std::string cannot_write(const std::string& file);
std::string cannot_compile(const std::string& reason);
std::string compiler_cannot_be_used(const std::string& compiler, const std::string& reason);
std::string includes_foreign_file(const std::string& name);
std::string cannot_be_linked();
std::string defines_main();
std::string calls_undefined(const std::string& function);

/// The function of the exercise is not in the file.
struct MissingFunction {
  std::string needed;                ///< "rigid::twice(double)"
  std::vector<std::string> defined;  ///< what is in the file instead
  bool is_inline = false;            ///< it is there, but marked so that only this file can call it
};
std::string missing_function(const MissingFunction& missing);

// --- why a file cannot be read at all; `file` is its name

std::string is_folder(const std::string& file);
std::string is_symbolic_link(const std::string& file);
std::string is_no_ordinary_file(const std::string& file);
std::string does_not_exist(const std::string& file);
std::string cannot_be_read(const std::string& file, const std::string& reason);
std::string is_too_large(const std::string& file);
std::string is_no_text(const std::string& file);

// --- trouble of our own

std::string cannot_write_to(const std::string& directory, const std::string& reason);
std::string cannot_use(const std::string& program, const std::string& reason);
std::string executable_is_gone();  ///< a reason

enum class ToolchainPart { compiler, prelude, worker, part_of_worker };
std::string part_is_missing(ToolchainPart part, const std::string& file);
std::string toolchain_cannot_be_read(const std::string& file);
std::string toolchain_of_another_format(const std::string& file);
std::string toolchain_is_damaged(const std::string& file, const std::string& reason);

// --- the first error, where no mistake is recognized

std::string compiler_says(const std::string& message);
std::string eigen_says(const std::string& advice);

// --- mistakes that do not compile: sizes

/// What an operand is: "3×1 vector", "number". The article is added here.
using Operand = const std::string&;

std::string number_noun();

/// "3×1 vector", "1×3 row vector", "3×3 matrix", "matrix"; negative: known at run time only.
std::string matrix_noun(int rows, int columns);

/// What stands behind the size of a type without a short name: "3×1 part", "3×1 expression".
std::string part_noun();
std::string expression_noun();

/// The operation, here and below, is a sign; empty if it is not known.
std::string different_sizes(Operand operation, Operand left, Operand right);
std::string row_and_column(Operand operation, Operand left, Operand right);
std::string does_not_fit_into(Operand source, Operand target);
std::string different_sizes();
std::string product_of_wrong_sizes(Operand left, int columns, Operand right, int rows);
std::string product_of_wrong_sizes();
std::string product_of_two_vectors();
std::string dot_needs_vectors();
std::string cross_needs_three();
std::string wrong_count_of_numbers(Operand type);
std::string numbers_in_matrix_constructor();
std::string number_as_matrix(Operand type);
std::string size_not_whole();
std::string vector_method_on_matrix();

// --- mistakes that do not compile: operators

std::string power_sign(Operand sign);
std::string list_needs_shift();
std::string number_assigned_to_matrix(Operand target);
std::string number_plus_matrix(Operand sign);
std::string division_by_vector(Operand divisor);
std::string order_of_vectors();
std::string number_and_vector_mixed(Operand wanted, Operand given);
std::string returns_wrong_kind(Operand wanted, Operand given);
std::string one_by_one_matrix();
std::string function_of_vector(Operand function, Operand argument);
std::string method_needs_vector(Operand method);
std::string standard_vector_is_no_vector();
std::string array_and_matrix();
std::string branches_differ();
std::string modulo_of_double();
std::string nothing_to_assign_to();
std::string arrow_for_dot();
std::string arrow_for_comparison();

// --- mistakes that do not compile: brackets and calls

std::string brackets_on_matrix();
std::string brackets_on_number();
std::string brackets_for_standard_vector();
std::string call_of_value(Operand name);  ///< name may be empty
std::string number_before_name();
std::string call_without_parentheses();
std::string argument_of_wrong_kind(Operand wanted, Operand given);
std::string wrong_count_of_arguments(bool too_few, Operand function);
std::string type_in_call();
std::string column_by_colon();
std::string list_in_brackets();

// --- mistakes that do not compile: const, names, types

std::string changes_constant(Operand name);  ///< name may be empty
std::string undeclared_pi();
std::string undeclared_outside_namespace(Operand name);
std::string degrees_function(Operand name);
std::string method_as_function(Operand name);
std::string missing_prefix(Operand name, Operand full_name);
std::string python_word(Operand name, Operand word);
std::string undeclared(Operand name);
std::string did_you_mean(Operand name, Operand suggestion);
std::string missing_include(Operand name, Operand header);
std::string matrix_functions_need_header();
std::string no_such_member(Operand type, Operand member, Operand suggestion);  ///< suggestion may be empty
std::string member_of_number(Operand member, Operand name);
std::string other_result_type(Operand signature);  ///< signature may be empty
std::string other_parameters(Operand found, Operand signature);
std::string no_result_type();
std::string return_without_value();
std::string result_by_assignment();
std::string const_behind_parameters();
std::string declared_twice(Operand name);
std::string shadows_parameter(Operand name);
std::string defined_twice(Operand name);
std::string marked(Operand word);  ///< static or constexpr before the function of the exercise
std::string ambiguous_call(Operand name);
std::string no_such_header(Operand header);
std::string include_without_hash();

// --- mistakes that do not compile: punctuation

std::string missing_semicolon();
std::string something_missing_before(Operand token);
std::string missing_closing_brace();
std::string surplus_closing_brace();
std::string missing_parenthesis(Operand parenthesis);
std::string surplus_parenthesis();
std::string function_inside_function();
std::string else_without_if();
std::string condition_without_parentheses();
std::string dot_for_colons();
std::string apostrophe_for_transpose();
std::string unterminated_text();
std::string unterminated_comment();
std::string foreign_character();

// --- mistakes that compile

std::string whole_number_division(Operand division, long result);
std::string degrees_in(Operand function, Operand angle);
std::string turned_into_degrees(Operand function);
std::string bitwise_for_power(Operand expression);
std::string decimal_comma();
std::string result_thrown_away(Operand method);
std::string empty_loop_body(Operand keyword);
std::string sum_without_start(Operand name, Operand type);
std::string rounded_pi(Operand number);
std::string keeps_expression(Operand name);
std::string returns_expression(Operand name);
std::string missing_return();
std::string used_before_set(Operand name);
std::string cut_to_whole_number(Operand type);
std::string kept_in_float();
std::string assignment_as_condition();
std::string chained_comparison();
std::string without_effect();
std::string part_without_effect();
std::string never_negative();
std::string misleading_indentation(Operand keyword);
std::string reference_to_local(Operand name);
std::string division_by_zero();
std::string falls_through();
std::string shadows_local(Operand name);
std::string never_used(Operand name);
std::string argument_never_used(Operand name);

}  // namespace workbook::messages
