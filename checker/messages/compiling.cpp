#include "checker/messages/compiling.hpp"

#include <fmt/format.h>

namespace workbook::messages {

namespace {

std::string quoted(const std::string& code) { return "`" + code + "`"; }

std::string sign_or_not(const std::string& operation) { return operation.empty() ? "this operation" : operation; }

/// "an operand" for "operand".
std::string one(const std::string& noun) {
  const bool vowel = !noun.empty() && std::string_view("aeiou8").find(noun.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + noun;
}

std::string capitalized(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') text.front() = static_cast<char>(text.front() - 32);
  return text;
}

/// The text with a full stop, if it has no end of its own.
std::string sentence(const std::string& text) {
  return text.ends_with('.') || text.ends_with('?') || text.ends_with('!') ? text : text + ".";
}

std::string spelt_out(const std::string& function) {
  if (function == "sin") return "sine";
  if (function == "cos") return "cosine";
  return "tangent";
}

std::string listed(const std::vector<std::string>& functions) {
  constexpr std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < functions.size() && i < most; ++i) text += (i > 0 ? ", " : "") + quoted(functions[i]);
  return functions.size() > most ? text + " and others" : text;
}

}  // namespace

std::string does_not_compile(int line) {
  if (line <= 0) return "Your file does not compile.";
  return fmt::format("Your file does not compile: the first error is in line {}.", line);
}

std::string does_not_compile(const std::string& error) {
  return fmt::format("Your file does not compile: {}", sentence(error));
}

std::string takes_too_long_to_compile() {
  return "Your file takes too long to compile; look for a template or an #include that never ends.";
}

std::string takes_too_much_memory_to_compile() {
  return "Compiling your file takes too much memory; look for a template or an #include that never ends.";
}

std::string makes_too_large_a_program() {
  return "Your file makes a program that is too large; look for a huge array.";
}

std::string no_room_to_compile() {
  return "There is no room to compile your file (is the disk full?); this is not your mistake.";
}

std::string cannot_write(const std::string& file) {
  return fmt::format("The checker cannot write {} (is the disk full?); this is not your mistake.", file);
}

std::string cannot_compile(const std::string& reason) {
  return fmt::format("The checker could not compile your file ({}); this is not your mistake.", reason);
}

std::string compiler_cannot_be_used(const std::string& compiler, const std::string& reason) {
  return fmt::format("The compiler {} cannot be used ({}); build the workbook again.", compiler, reason);
}

std::string includes_foreign_file(const std::string& name) {
  return fmt::format(
      "Your file includes {}, but it is compiled alone: include only headers of the course, of Eigen and of the "
      "standard library.",
      name);
}

std::string cannot_be_linked() {
  return "Your file compiles, but cannot be linked into a program; see the linker's message.";
}

std::string defines_main() { return "Your file defines main(); leave it out, the checker calls your function itself."; }

std::string calls_undefined(const std::string& function) {
  return fmt::format(
      "Your file calls `{}`, which it does not define; each file is compiled alone, so write what you need into this "
      "one.",
      function);
}

std::string missing_function(const MissingFunction& missing) {
  const std::string message = fmt::format("Your file does not define {}", quoted(missing.needed));
  if (missing.is_inline)
    return message + " for others: it is there, but marked inline or as a template; leave that out.";
  if (missing.defined.empty()) return message + "; it defines no function that can be called from outside.";
  const auto name_of = [](const std::string& function) { return function.substr(0, function.find('(')); };
  const std::string needed_name = name_of(missing.needed);
  for (const std::string& defined : missing.defined) {
    if (name_of(defined) == needed_name)
      return fmt::format("{}; it defines {}, whose parameters differ.", message, quoted(defined));
    if ("rigid::" + name_of(defined) == needed_name)
      return fmt::format("{}; it defines {} outside the namespace rigid.", message, quoted(defined));
  }
  return fmt::format("{}; it defines {}.", message, listed(missing.defined));
}

std::string is_folder(const std::string& file) {
  return fmt::format("{} is a folder; name the file with your function.", file);
}

std::string is_symbolic_link(const std::string& file) {
  return fmt::format("{} is a symbolic link; put the file itself there.", file);
}

std::string is_no_ordinary_file(const std::string& file) {
  return fmt::format("{} is not an ordinary file; save your function as an ordinary text file.", file);
}

std::string does_not_exist(const std::string& file) {
  return fmt::format("{} does not exist; check the name and the folder.", file);
}

std::string cannot_be_read(const std::string& file, const std::string& reason) {
  return fmt::format("{} cannot be read ({}); check its name and permissions.", file, reason);
}

std::string is_too_large(const std::string& file) {
  return fmt::format("{} is larger than 1 MiB; hand in the source file only.", file);
}

std::string is_no_text(const std::string& file) {
  return fmt::format("{} is not a text file; hand in the source file, saved as UTF-8, not a compiled one.", file);
}

std::string cannot_write_to(const std::string& directory, const std::string& reason) {
  return fmt::format("The checker cannot write to {} ({}); this is not your mistake.", directory, reason);
}

std::string cannot_use(const std::string& program, const std::string& reason) {
  return fmt::format("The program {} cannot be used ({}); build the workbook again.", program, reason);
}

std::string executable_is_gone() { return "the executable is gone"; }

std::string part_is_missing(ToolchainPart part, const std::string& file) {
  const auto missing = [&](const char* role) {
    return fmt::format("The {} {} is missing; build the workbook again.", role, file);
  };
  switch (part) {
    case ToolchainPart::compiler:
      return missing("compiler");
    case ToolchainPart::prelude:
      return missing("prelude");
    case ToolchainPart::worker:
      return missing("worker");
    case ToolchainPart::part_of_worker:
      break;
  }
  return missing("worker's part");
}

std::string toolchain_cannot_be_read(const std::string& file) {
  return fmt::format("The toolchain file {} cannot be read; build the workbook again.", file);
}

std::string toolchain_of_another_format(const std::string& file) {
  return fmt::format("The toolchain file {} has another format than this checker; build the workbook again.", file);
}

std::string toolchain_is_damaged(const std::string& file, const std::string& reason) {
  return fmt::format("The toolchain file {} is damaged ({}); build the workbook again.", file, reason);
}

std::string compiler_says(const std::string& message) {
  return fmt::format("The compiler says: {}", sentence(message));
}

std::string eigen_says(const std::string& advice) { return fmt::format("Eigen says: {}", sentence(advice)); }

std::string number_noun() { return "number"; }

std::string matrix_noun(int rows, int columns) {
  const auto size = [](int count) { return count < 0 ? std::string("n") : std::to_string(count); };
  const std::string sizes = fmt::format("{}×{} ", size(rows), size(columns));
  if (columns == 1 && rows != 1) return (rows < 0 ? "" : sizes) + "vector";
  if (rows == 1 && columns != 1) return (columns < 0 ? "" : sizes) + "row vector";
  return (rows < 0 && columns < 0 ? "" : sizes) + "matrix";
}

std::string part_noun() { return "part"; }
std::string expression_noun() { return "expression"; }

std::string different_sizes(Operand operation, Operand left, Operand right) {
  return fmt::format("The two sides of {} have different sizes: {} and {}.", sign_or_not(operation), one(left),
                     one(right));
}

std::string row_and_column(Operand operation, Operand left, Operand right) {
  return fmt::format("A row and a column meet at {}: {} and {}. Transpose one of them, as in v.transpose().",
                     sign_or_not(operation), one(left), one(right));
}

std::string does_not_fit_into(Operand source, Operand target) {
  return fmt::format("{} does not fit into {}.", capitalized(one(source)), one(target));
}

std::string different_sizes() {
  return "Matrices or vectors of different sizes are combined here; give both the same size.";
}

std::string product_of_wrong_sizes(Operand left, int columns, Operand right, int rows) {
  return fmt::format(
      "In a product, the left side must have as many columns as the right side has rows; here {} with {} column{} "
      "stands before {} with {} row{}.",
      one(left), columns, columns == 1 ? "" : "s", one(right), rows, rows == 1 ? "" : "s");
}

std::string product_of_wrong_sizes() {
  return "In a product, the left side must have as many columns as the right side has rows.";
}

std::string product_of_two_vectors() {
  return "Two vectors cannot be multiplied by *: write a.dot(b) for the scalar product, or a.cross(b) for the cross "
         "product.";
}

std::string dot_needs_vectors() {
  return "dot() needs two vectors with the same number of components; multiply a matrix and a vector by *.";
}

std::string cross_needs_three() {
  return "cross() needs two vectors with exactly three components, and the types must say so: use Vector3d, not "
         "VectorXd.";
}

std::string wrong_count_of_numbers(Operand type) {
  return fmt::format("The number of values in the parentheses or braces does not fit {}.", one(type));
}

std::string numbers_in_matrix_constructor() {
  return "The numbers of a matrix do not go into its parentheses: define the matrix, then fill it with <<, as in A << "
         "1, 2, 3, ...;";
}

std::string number_as_matrix(Operand type) {
  return fmt::format(
      "One number in parentheses does not make a {0}: write {0}::Zero(), {0}::Identity() or {0}::Constant(number).",
      type);
}

std::string size_not_whole() {
  return "The size of a vector or matrix must be a whole number, but here it is a double.";
}

std::string vector_method_on_matrix() {
  return "What is used here exists for vectors only, but it is given a matrix; an entry of a matrix is A(i, j), a "
         "column A.col(j).";
}

std::string power_sign(Operand sign) {
  return fmt::format("{} is not a power in C++{}; write x * x or std::pow(x, 2).", sign,
                     sign == "^" ? " (it combines the bits of whole numbers)" : "");
}

std::string list_needs_shift() {
  return "A list of numbers is put into a vector or matrix with <<, not with =, as in v << 1, 2, 3;";
}

std::string number_assigned_to_matrix(Operand target) {
  return fmt::format("A number is assigned to a {0}: write {0}::Zero() for zeros, or {0}::Constant(number).", target);
}

std::string number_plus_matrix(Operand sign) {
  return fmt::format(
      "A number and a matrix or vector cannot be joined by {}; multiply the number by Identity() if a matrix is meant, "
      "as in x * Matrix3d::Identity().",
      sign);
}

std::string division_by_vector(Operand divisor) {
  return fmt::format(
      "One cannot divide by {}: a.cwiseQuotient(b) divides component by component, and A.inverse() is the inverse of a "
      "matrix.",
      one(divisor));
}

std::string order_of_vectors() {
  return "Vectors and matrices have no order: compare their lengths, as in a.norm() < b.norm(), or single components.";
}

std::string number_and_vector_mixed(Operand wanted, Operand given) {
  return fmt::format("{} is wanted here, but this is {}.", capitalized(one(wanted)), one(given));
}

std::string returns_wrong_kind(Operand wanted, Operand given) {
  return fmt::format("The function returns {}, but what is returned here is {}.", one(wanted), one(given));
}

std::string one_by_one_matrix() {
  return "This is a matrix with one entry, not a number: write a.dot(b) in place of a.transpose() * b, or put .value() "
         "behind the product in parentheses.";
}

std::string function_of_vector(Operand function, Operand argument) {
  return fmt::format(
      "{} takes a number, but here it is given {}; a vector's length is v.norm(), its square v.squaredNorm().",
      function, one(argument));
}

std::string method_needs_vector(Operand method) {
  return fmt::format("{} needs a vector in its parentheses, not a number.", method);
}

std::string standard_vector_is_no_vector() {
  return "A std::vector or an array is only a list: it cannot be added, multiplied or turned into a vector of Eigen. "
         "Use Vector3d or VectorXd for calculating.";
}

std::string array_and_matrix() {
  return "A.array() and a matrix cannot be combined: write .array() on both sides, or on neither.";
}

std::string branches_differ() {
  return "The two results of ? : have different types; write an if with two returns, or name the type on both sides, "
         "as in Matrix3d(A).";
}

std::string modulo_of_double() {
  return "% is the remainder of whole numbers only; for doubles write std::fmod(a, b).";
}

std::string nothing_to_assign_to() {
  return "Left of = must stand a variable that can be changed; if two values are to be compared, write ==.";
}

std::string arrow_for_dot() { return "-> is for pointers only; write a dot here, as in v.norm()."; }

std::string arrow_for_comparison() { return "=> does not exist in C++; greater or equal is >=."; }

std::string brackets_on_matrix() {
  return "An entry of a matrix is A(i, j), with parentheses; the brackets [ ] work with vectors only.";
}

std::string brackets_on_number() { return "This is a number and has no entries: [ ] does not belong behind it."; }

std::string brackets_for_standard_vector() { return "An element of a std::vector is v[i], with brackets."; }

std::string call_of_value(Operand name) {
  return fmt::format(
      "{} is no function, but ( stands behind it: write * if a product is meant; an entry of a matrix is A(i, j).",
      name.empty() ? "What stands here" : quoted(name));
}

std::string number_before_name() { return "A * is missing behind a number: a product is written 2 * x, not 2x."; }

std::string call_without_parentheses() {
  return "A function is named here, but not called: its parentheses are missing, as in A.transpose(), v.norm() or "
         "cos(x).";
}

std::string argument_of_wrong_kind(Operand wanted, Operand given) {
  return fmt::format("The function that is called here needs {} at this place, but gets {}.", one(wanted), one(given));
}

std::string wrong_count_of_arguments(bool too_few, Operand function) {
  return fmt::format("Too {} arguments for {}.", too_few ? "few" : "many", quoted(function));
}

std::string type_in_call() {
  return "Where a function is called, only values stand in the parentheses, without their types.";
}

std::string column_by_colon() {
  return "A column of a matrix is A.col(j), a row is A.row(i); a : does not belong here.";
}

std::string list_in_brackets() {
  return "A list of numbers stands in braces or behind <<, not in [ ]: write Vector3d v(1, 2, 3);";
}

std::string changes_constant(Operand name) {
  return fmt::format("{} is const and cannot be changed; make a variable of your own for the result.",
                     name.empty() ? "What is changed here" : quoted(name));
}

std::string undeclared_pi() { return "C++ has no pi of that name: write std::numbers::pi."; }

std::string undeclared_outside_namespace(Operand name) {
  return fmt::format(
      "{} is known in the namespace rigid only: your function must stand between `namespace rigid {{` and its `}}`.",
      quoted(name));
}

std::string degrees_function(Operand name) {
  return fmt::format("There is no function {}: {} and its relatives work in radians, as all angles of the course do.",
                     quoted(name), name.substr(0, name.size() - 1));
}

std::string method_as_function(Operand name) {
  return fmt::format("{0} is a method: it stands behind a vector or matrix and a dot, as in {1}.", quoted(name),
                     name == "cross" || name == "dot" ? "a." + name + "(b)" : "A." + name + "()");
}

std::string missing_prefix(Operand name, Operand full_name) {
  return fmt::format("The namespace is missing: write {} for {}.", quoted(full_name), quoted(name));
}

std::string python_word(Operand name, Operand word) {
  return fmt::format("{} is not a word of C++; write {}.", quoted(name), quoted(word));
}

std::string undeclared(Operand name) {
  return fmt::format("{} is not known here: is it spelt as where it was declared, and was that before this line?",
                     quoted(name));
}

std::string did_you_mean(Operand name, Operand suggestion) {
  return fmt::format("There is no {}; did you mean {}?", quoted(name), quoted(suggestion));
}

std::string missing_include(Operand name, Operand header) {
  return fmt::format("{} needs a header: write #include {} at the top of your file.", quoted(name), header);
}

std::string matrix_functions_need_header() {
  return "Functions of matrices, such as A.exp(), need a header: write #include <unsupported/Eigen/MatrixFunctions>";
}

std::string no_such_member(Operand type, Operand member, Operand suggestion) {
  return fmt::format("{} has nothing called {}{}", capitalized(one(type)), quoted(member),
                     suggestion.empty() ? "." : fmt::format("; did you mean {}?", quoted(suggestion)));
}

std::string member_of_number(Operand member, Operand name) {
  return fmt::format("{} is a number and has no {}.", quoted(name), quoted(member));
}

std::string other_result_type(Operand signature) {
  if (signature.empty()) return "The result type differs from the one in the contract.";
  return fmt::format("The result type differs from the contract: it says {}.", quoted(signature));
}

std::string other_parameters(Operand found, Operand signature) {
  return fmt::format("The contract has no {}; keep the result, the name and the parameters of {}.", quoted(found),
                     quoted(signature));
}

std::string no_result_type() {
  return "The result type is missing before the name of the function, as the double in double f(double x).";
}

std::string return_without_value() {
  return "A value is missing behind return: the function must hand back its result.";
}

std::string result_by_assignment() {
  return "A function hands back its result with return, not by an assignment to its own name.";
}

std::string const_behind_parameters() {
  return "The const behind the parentheses is for methods of a class only; leave it out.";
}

std::string declared_twice(Operand name) {
  return fmt::format("{} is declared for the second time; to give it a new value, leave out the type.", quoted(name));
}

std::string shadows_parameter(Operand name) {
  return fmt::format(
      "{} is an argument of the function already: leave out the type to change it, or choose another name.",
      quoted(name));
}

std::string defined_twice(Operand name) {
  return fmt::format("{} is defined twice; keep one of the two.", quoted(name));
}

std::string marked(Operand word) {
  return fmt::format("The function of an exercise must not be {}: leave out this word.", word);
}

std::string ambiguous_call(Operand name) {
  return fmt::format(
      "There are several functions {} that fit equally well: one of the course and one of your own. Give yours another "
      "name or the contract's parameters.",
      quoted(name));
}

std::string no_such_header(Operand header) {
  return fmt::format(
      "There is no header {}: Eigen is <Eigen/Dense>, and the header of the lecture is named at the top of the file "
      "you were given.",
      quoted(header));
}

std::string include_without_hash() { return "A # is missing: write #include."; }

std::string missing_semicolon() { return "A ; is missing here, at the end of the statement."; }

std::string something_missing_before(Operand token) {
  return fmt::format("Before {} something is missing, such as an operator (a * is never left out), a comma or a ;",
                     quoted(token));
}

std::string missing_closing_brace() {
  return "A closing brace } is missing: the file ends while a { is still open. Count the braces from here upwards.";
}

std::string surplus_closing_brace() { return "There is one } too many: all braces are closed before this one."; }

std::string missing_parenthesis(Operand parenthesis) { return fmt::format("A {} is missing here.", parenthesis); }

std::string surplus_parenthesis() { return "There is a ) too many, or its ( is missing."; }

std::string function_inside_function() {
  return "A function begins inside another one: is a closing brace } missing above this line?";
}

std::string else_without_if() {
  return "This else belongs to no if: look for a ; directly behind the if (...), or put the statements before the else "
         "into braces.";
}

std::string condition_without_parentheses() {
  return "Behind if, for and while stand parentheses, as in if (x > 0) or for (int i = 0; i < 3; ++i).";
}

std::string dot_for_colons() {
  return "Behind the name of a type or namespace stands ::, not a dot, as in Matrix3d::Identity() or std::sqrt(x).";
}

std::string apostrophe_for_transpose() { return "An apostrophe does not transpose in C++; write A.transpose()."; }

std::string unterminated_text() {
  return "A text or character begins here, but its closing quotation mark is missing.";
}

std::string unterminated_comment() { return "The comment that begins here has no end: */ is missing."; }

std::string foreign_character() {
  return "Here stands a character that C++ does not know, perhaps copied from a document: type the operators and "
         "quotation marks on the keyboard.";
}

std::string whole_number_division(Operand division, long result) {
  return fmt::format(
      "{} divides whole numbers and gives {}; write at least one of them with a decimal point, as in 1.0.",
      quoted(division), result);
}

std::string degrees_in(Operand function, Operand angle) {
  return fmt::format(
      "{0} takes radians: {0}({1}) is not the {2} of {1} degrees. Multiply degrees by std::numbers::pi / 180.",
      function, angle, spelt_out(function));
}

std::string turned_into_degrees(Operand function) {
  return fmt::format("{} takes radians, but 180 / pi turns its argument into degrees.", function);
}

std::string bitwise_for_power(Operand expression) {
  return fmt::format("{} is not a power in C++: ^ combines the bits of whole numbers. Write x * x or std::pow(x, 2).",
                     quoted(expression));
}

std::string decimal_comma() {
  return "A comma is not a decimal point: what stands before it is thrown away. Write 0.5, not 0,5.";
}

std::string result_thrown_away(Operand method) {
  return fmt::format(
      "{0}() changes nothing: it returns a new value, and here nobody keeps it. Write A = ..., or use a method that "
      "works in place.",
      method);
}

std::string empty_loop_body(Operand keyword) {
  return fmt::format(
      "The ; directly behind {} (...) is all that it does: what follows does not belong to it. Leave out this ;",
      keyword);
}

std::string sum_without_start(Operand name, Operand type) {
  return fmt::format("{0} has no value yet when something is added to it here: begin with {1} {2} = {1}::Zero();",
                     quoted(name), type, name);
}

std::string rounded_pi(Operand number) { return fmt::format("{} is only near π; write std::numbers::pi.", number); }

std::string keeps_expression(Operand name) {
  return fmt::format(
      "With auto, {} holds no result but a formula that Eigen computes at every use, from operands that may have "
      "changed or gone by then: write its type in place of auto.",
      quoted(name));
}

std::string returns_expression(Operand name) {
  return fmt::format(
      "With auto, {} returns no result but a formula over its operands, which may be gone when it is computed: write "
      "the type in place of auto.",
      quoted(name));
}

std::string missing_return() {
  return "The function can reach its end without a return; then its result is arbitrary. Return a value on every way "
         "through it.";
}

std::string used_before_set(Operand name) {
  return fmt::format("{} is used here before it, or this part of it, was given a value.", quoted(name));
}

std::string cut_to_whole_number(Operand type) {
  return fmt::format("A double is turned into a whole number ({}) here: what stands behind the decimal point is lost.",
                     type);
}

std::string kept_in_float() { return "A float keeps only about 7 digits; use double."; }

std::string assignment_as_condition() { return "The = in this condition assigns a new value; to compare, write ==."; }

std::string chained_comparison() {
  return "a < b < c does not compare three numbers in C++ (a < b becomes 0 or 1 first); write a < b && b < c.";
}

std::string without_effect() { return "This statement has no effect: what it computes is not kept."; }

std::string part_without_effect() {
  return "A part of this statement has no effect: what stands on one side of a comma is computed and thrown away.";
}

std::string never_negative() {
  return "This compares an unsigned number with 0, which it is never below, so that the result is always the same; "
         "count with int.";
}

std::string misleading_indentation(Operand keyword) {
  return fmt::format(
      "Only the first statement behind this {} belongs to it, although more are indented; put them into braces.",
      keyword);
}

std::string reference_to_local(Operand name) {
  return fmt::format("This returns a reference to {}, which is gone when the function ends; return the value itself.",
                     quoted(name));
}

std::string division_by_zero() { return "Here a whole number is divided by zero."; }

std::string falls_through() {
  return "Behind this statement the switch runs on into the next case; write break; if it should not.";
}

std::string shadows_local(Operand name) {
  return fmt::format(
      "This is a second, new {}: the one outside of these braces stays as it was. To change that one, leave out the "
      "type.",
      quoted(name));
}

std::string never_used(Operand name) {
  return fmt::format("{} is declared, but its value is never used.", quoted(name));
}

std::string argument_never_used(Operand name) { return fmt::format("The argument {} is never used.", quoted(name)); }

}  // namespace workbook::messages
