#include "checker/explain/slips.hpp"

#include "checker/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>

namespace workbook {

namespace {

// Of each pattern $1 is what stands in ( ) or { }, with these, and $2 what is changed.
const std::string brackets = R"((?(DEFINE)([({](?:[^(){}]|(?1))*[)}])))";
#define ANY R"((?:[^(){},;]|(?1))+)"        // between commas
#define PART R"(\s*((?:[^(){},;]|(?1))+))"  // the same, as a group
#define PI R"((?:\w+\s*::\s*)*(?:M_PI|EIGEN_PI|pi|3\.14\d*))"
#define BEGINS_AT_0 R"((?:\bdouble\s+|,\s*)(\w+)\s*=\s*(0(?:\.0*)?)\s*[,;])"
#define COMPARISON R"((?:[^(){};,?&|<>=!]|(?1))+[<>]=?(?:[^(){};,?&|<>=!]|(?1))+)"

/// What is written, and what was meant, with $2, $3, ... of the pattern.
struct Slip {
  const char* name = "";
  const char* pattern = "";
  const char* change = "";  ///< in the place of $2
  const char* sentence = "";
  std::size_t group = 2;    ///< or of another one
  bool everywhere = false;  ///< all places at once, and the first one is told
};

constexpr Slip slip_table[] = {
    {"integer_division", R"(#[ \t]*define\b[^\n]*?(?<![\w.])\d+\s*(/)\s*\d+(?![\w.]))", "* 1.0 /",
     "Whole numbers are divided here, and what follows the decimal point is dropped: make one of them a double."},
    {"negative_remainder", R"(((?:std\s*::\s*)?\bfmod)\s*\()",
     "[](double a, double b) { return a - b * std::floor(a / b); } ",
     "fmod keeps the sign of its first argument, so that the remainder of a negative number is negative."},
    {"negative_remainder", R"(\(\s*\w+\s*-\s*[12]()\s*\)\s*%\s*(\w+))", " + $3",
     "% keeps the sign: -1 % $3 is -1, which is no index. Add the divisor first, as in (i + 2) % 3.", 2, true},
    {"second_name",
     R"((?:^|[;{}])\s*(?:const\s+)?[\w:]+\s*(&)\s*(\w+)\s*=\s*([A-Za-z]\w*)(?=[^]*\b(?:\3|\4)\b\s*(?:\[[^\]]*\]\s*)?[-+*/]?=[^=]))",
     "", "With &, `$3` is no copy but a second name of `$4`: what changes the one changes the other."},
    {"scalar_last", R"(\bQuaterniond(?:\s+\w+)?\s*\(()" PART "," PART "," PART "," PART R"()\))", "$6, $3, $4, $5",
     "Quaterniond takes w first: Quaterniond(w, x, y, z), although coeffs() holds x, y, z, w."},
    {"scalar_last", R"((\b(\w+)\s*\.\s*coeffs\s*\(\s*\)(?!\s*(?:<<|=[^=]))))",
     "Eigen::Vector4d($3.w(), $3.x(), $3.y(), $3.z())",
     "coeffs() holds x, y, z, w in this order: w is `$3.w()`, and the vector `$3.vec()`."},
    {"scalar_last",
     R"(\.\s*coeffs\s*\(\s*\)\s*(?:<<|=\s*(?:[\w:]*Vector4d\s*)?\()()" PART "," PART "," PART "," PART R"()[;)])",
     "$4, $5, $6, $3", "coeffs() holds x, y, z, w in this order: w comes last, unlike in Quaterniond(w, x, y, z)."},
    {"size_in_bytes", R"((sizeof\s*\(\s*(?!double|int|float)(\w+)\s*\)(?:\s*/\s*sizeof\s*(?1))?))", "std::size($3)",
     "sizeof counts the bytes of the object, not its entries: these are `$3.size()`."},
    {"columns_for_rows", R"(\bMap\s*<\s*(?:const\s+)?((?:Eigen\s*::\s*)?Matrix([234])d))",
     "Eigen::Matrix<double, $3, $3, Eigen::RowMajor>",
     "Eigen reads a matrix column by column: numbers that stand side by side become columns."},
    {"columns_for_rows", R"(<<(?=\s*[A-Za-z])()" PART "," PART "," PART R"();)",
     "($3).transpose(), ($4).transpose(), ($5).transpose()",
     "With << these stand side by side, as columns: rows are a.transpose(), b.transpose(), ..."},
    {"copied_element", R"(\bfor\s*\([^;&()]*\w\s+(\w+)\s*:(?![:{]|\s+\{))", "&$2",
     "`$2` is a copy of each element, which the list does not notice: write & before `$2`."},
    {"copied_element", R"(\bfor\s*\([^;&()]*\w\s+((\w+)\s*:\s*\{)" PART "," PART "," PART R"(\}))",
     "&$3 : {std::ref($4), std::ref($5), std::ref($6)}",
     "`$3` is a copy of each of these variables, which keep their values: change them one by one."},
    {"columns_for_rows", R"(=\s*((\w+)\s*\.\s*data\s*\(\s*\))(?=\s*(?:\+[^;]*)?;))",
     "(new Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>($3))->data()",
     "data() holds a matrix column by column: x, y, z of the first column, then those of the second.", 2, true},
    {"columns_for_rows", R"(\bdouble\s+(\w+)\s*\[[^]*?\bMatrix3d(?:\s+\w+)?\s*[({]\s*(\2)\s*[)}])",
     "(Eigen::Matrix<double, 3, 3, Eigen::RowMajor>($2))",
     "A matrix that is made of an array takes its numbers column by column: `<<` takes them row by row.", 3},
    {"columns_for_rows",
     R"(<<(\s*(\w+)\s*\.\s*transpose\s*\(\s*\)\s*,\s*(\w+)\s*\.\s*transpose\s*\(\s*\)\s*,\s*(\w+)\s*\.\s*transpose\s*\(\s*\))\s*;)",
     "$3, $4, $5", "With << these are the rows: as columns they stand without transpose().", 2, true},
    {"braces_for_size", R"(\bvector\s*<\s*(?:double|int)\s*>\s*\w*\s*(\{\s*(\w+\s*(?:,\s*[\d.]+\s*)?)\}))", "($3)",
     "In braces stand the elements themselves: a size stands in parentheses, as in v(3, 0.0)."},
    {"copied_part",
     R"(\b((?:Vector|Matrix)[23X]d)\s+(\w+)\s*=\s*(\w+)\s*\.\s*(?:col|row|block|head|tail|segment|diagonal)\b)", "auto",
     "`$3` is a copy of a part of `$4`: what changes the one does not change the other. With auto, `$3` is this part "
     "itself."},
    {"kept_view",
     R"(\bauto\s+(\w+)\s*=\s*((\w+)\s*\.\s*(?:col|row|head|tail|segment|block|diagonal|transpose)\s*(?:<[^;<>]*>\s*)?(?1))\s*;)",
     "workbook_value($3)",
     "With auto, `$2` is no copy but a part of `$4` itself, which changes with it: write its type in place of auto.",
     3},
    {"reference_to_temporary", R"(\b(minmax\s*\()" PART "," PART R"(\)))", "minmax({$3, $4})",
     "minmax hands back references to both values, which are gone at the end of the line if they are computed here: "
     "write std::minmax({a, b})."},
    {"one_too_far", R"(\bseq\s*\()" ANY "," PART R"(\))", "$2 - 1",
     "The end of seq(first, last) belongs to the sequence, unlike that of a slice in Python."},
    {"end_and_step", R"(\bintegrate_(?:adaptive|const)\s*\((?:)" ANY R"(,){4}()" PART "," PART R"()[,)])", "$4, $3",
     "After the start comes the end, and then the step: these two are exchanged."},
    {"other_method", R"(\.\s*(cwiseInverse)\s*\()", "inverse",
     "cwiseInverse() takes 1/x of each entry; the inverse matrix is A.inverse()."},
    {"entrywise_product", R"((\b(\w+)\s*\.\s*array\s*\(\s*\)\s*\.\s*square\s*\(\s*\)(?:\s*\.\s*matrix\s*\(\s*\))?))",
     "($3 * $3)", "array().square() squares entry by entry; the square of a matrix is `$3 * $3`."},
    {"discarded_result", R"([;{})]\s*\w+(?:\s*\.\s*\w+\s*(?1))?\s*(\*)(?!=)[^;={}]*;)",
     "*=", "This product is computed and not kept: write *= in place of *."},
    {"length_not_1", R"((\b\w+)\s*\.\s*toRotationMatrix\b)", "Eigen::Quaterniond($2).normalized()",
     "A quaternion is a rotation only if its length is 1: take `$2.normalized()`."},
    {"square_of_length", R"(\bstd\s*::\s*(norm)\s*\()", "abs",
     "std::norm of a complex number is the square of its length, which is std::abs."},
    {"truth_value", R"(\b(bool)\s+(\w+)\s*[=({])", "double",
     "A bool is only true or false, 1 or 0, and no other number: make `$3` an int or a double."},
    {"truth_value",
     R"((?|\b(?:double|int|auto)\s+\w+\s*=\s*()" COMPARISON R"()\s*;|[*>]\s*\(()" COMPARISON R"()\)|\(()" COMPARISON
     R"()\)(?=\s*\*)))",
     "($2) ? 1 : -1", "A comparison counts as 1 or 0, and never as -1: for a sign, write x > 0 ? 1 : -1."},
    {"base_first", R"(\bpow\s*\(()" PART "," PART R"()\))", "$4, $3", "The base comes first in pow(base, exponent)."},
    {"size_first", R"(\bcopysign\s*\(()" PART "," PART R"()\))", "$4, $3",
     "The size comes first in copysign(size, sign)."},
    {"number_first", R"(\bclamp\s*\((\s*(-?[\d.e]+),)" PART "," PART R"()\))", "$4, $3, $5",
     "The number itself comes first in clamp(x, lowest, highest)."},
    {"ones", R"(\bMatrix\w+\s*::\s*(Ones)\s*\()", "Identity",
     "Ones() has a 1 in every entry; the unit matrix is Matrix3d::Identity().", 2, true},
    {"modulus_first", R"(\bellint_[12]\s*\(()" PART "," PART R"()\))", "$4, $3",
     "The modulus k comes first in ellint_1(k, phi), and then the angle."},
    {"modulus_first", R"(\bellint_3\s*\(()" PART "," PART R"()[,)])", "$4, $3",
     "The modulus k comes first in ellint_3(k, n, phi), and then the characteristic n."},
    {"modulus_squared", R"(\b(?:comp_)?ellint_[12]\s*\(()" PART R"()[,)])", "std::sqrt($3)",
     "These functions take the modulus k itself, and not its square m as in other tools: put in a root."},
    {"modulus_first", R"(\bjacobi_\w+\s*\(()" PART "," PART R"()[,)])", "$4, $3",
     "The modulus k comes first in jacobi_elliptic(k, u, &cn, &dn), and then the argument."},
    {"cn_before_dn", R"(\bjacobi_elliptic\s*\((?:)" ANY R"(,){2}()" PART "," PART R"()\))", "$4, $3",
     "The place for cn comes before that for dn in jacobi_elliptic(k, u, &cn, &dn)."},
    {"last_whole_step", R"(\b(integrate_const)\b)", "integrate_adaptive",
     "integrate_const stops at the last whole step before the end; integrate_adaptive goes on to the end."},
    {"any_order", R"(\b(EigenSolver)\s*<)", "SelfAdjointEigenSolver",
     "EigenSolver returns its eigenvalues in no certain order; Eigen::SelfAdjointEigenSolver in ascending order."},
    {"row_first", R"(\bblock\s*<[^<>]*>\s*\(()" PART "," PART R"()\))", "$4, $3",
     "The row comes first, and then the column, in block<3, 3>(row, column)."},
    {"arguments_of_atan2", R"(\batan2\s*\(()" PART "," PART R"()\))", "$4, $3",
     "The y comes first in atan2(y, x): here the x is given first."},
    {"smallest_positive", R"(\bnumeric_limits\s*<\s*\w+\s*>\s*::\s*(min)\s*\()", "lowest",
     "min() of a double is the smallest positive number; the most negative one is lowest()."},
    {"octal_number", R"((?<![\w.])(?<![eE][-+])(0+([1-9]\d*))(?![\w.]))", "$3",
     "A whole number that begins with 0 is read in base 8: leave the 0 out.", 2, true},
    {"signbit", R"(((?:std\s*::\s*)?\bsignbit)\s*\()", "[](double x) { return std::signbit(x) ? -1.0 : 1.0; }",
     "signbit is true, or 1, for negative numbers and 0 for others: a sign is std::copysign(1.0, x).", 2, true},
    {"lower_triangle", R"(\.\s*(ldlt|llt)\s*\()", "partialPivLu",
     "$2() reads only the lower half of a matrix, which it takes for symmetric: of others take partialPivLu().", 2,
     true},
    {"degrees", R"(\b(M_2_PI)\b)", "(2 * 3.14159265358979323846)", "M_2_PI is 2/π: for 2π write 2 * M_PI.", 2, true},
    {"value_from_before", R"((\b(\w+)\s*(--|\+\+))\s*[-+*/])", "($4$3)",
     "`$3$4` hands on the value from before it is changed: write $4$3."},
    {"other_method", R"(\.\s*(tail)\b)", "head", "tail() takes the last entries: the first ones are head()."},
    {"other_method", R"(\.\s*(head)\b)", "tail", "head() takes the first entries: the last ones are tail()."},
    {"last_turn_only", R"((?:[;{})]|\belse)\s*\w+\s*(=)\s*[^;{}=?]+?(?:[<>]=?|[=!]=)[^;{}?]+;)",
     "|=", "= keeps what the last turn says: once true it stays true with |=.", 2, true},
    {"changed_copy",
     R"(\]\s*\((?:[^()]*,)?\s*(?:Eigen\s*::\s*)?(?:Vector\w+|Matrix\w+|double|auto)()\s+(\w+)\s*[,)](?=[^{}]*\{[^{}]*\b\3\b\s*(?:[-+*/]?=(?!=)|\[[^\]]*\]\s*[-+*/]?=(?!=)|\.\s*(?:normalize|setZero|transposeInPlace)\b)))",
     " &", "`$3` is a copy of what this function is called with: write & behind its type.", 2, true},
    {"min_for_max", R"(\b(max(\s*\(\s*(?:[^(){};,]|(?1))+,\s*(?:std\s*::\s*)?)min)\b)", "min$3max",
     "max(1, min(-1, x)) is always 1: min and max are exchanged."},
    {"min_for_max", R"(\b(min(\s*\(\s*(?:[^(){};,]|(?1))+,\s*(?:std\s*::\s*)?)max)\b)", "max$3min",
     "min(-1, max(1, x)) is always -1: min and max are exchanged."},
    {"whole_cast", R"((?:\(\s*|<\s*|\b)(int|long)(?=\s*(?:\)|>\s*\(|\()))", "double",
     "$2 keeps only what stands before the decimal point."},
    {"narrowing", R"(\b(?:vector|array)\s*<\s*(int|long)\b[^;<>]*>\s*(\w+)\b(?![^]*[\[(]\s*\3\s*[\[(]))", "double",
     "`$3` holds whole numbers, and drops what follows each decimal point: make them double."},
    {"missing_else", R"(\bif\s*(?1)\s*(?1)\s*()\{)", "else ",
     "This block follows whether the condition is true or not: an else is missing in front of it."},
    {"negative_number",
     R"((?:\bif\s*\(|\bwhile\s*\(|\breturn\b|=|&&|\|\|)\s*((?:(?!\b\w*abs\b|\bnorm\b)[^<>=&|;{}?])+?)\s*<\s*[\d.]*e-\d)",
     "std::abs($2)", "Every negative number is smaller than this: compare std::abs of it."},
    {"negative_number", R"(\bwhile\s*\(\s*((?:(?!\b\w*abs\b|\bnorm\b)[^<>=&|;{}?])+?)\s*>\s*[\d.]*e-\d)",
     "std::abs($2)", "A negative number ends this loop too, however large it is: compare std::abs of it."},
    {"bracket_of_abs", R"(\babs\s*\(((()(?:[^(){};<>]|(?1))+?)([<>]=?)((?:[^(){};]|(?1))+))\))", "$3) $5 ($6",
     "The bracket of abs ends behind the comparison here, of which it takes the size: 0 or 1. Close it before."},
    {"copy_of_itself", R"(\bfunction\s*<[^;{}]*>\s*(\w+)\s*(?:;\s*\w+\s*)?=\s*\[([^\]&]*)\])", "&",
     "The lambda keeps a copy of `$2` from before it was given this lambda: write [&].", 3},
    {"place_for_element",
     R"((((?:std\s*::\s*)?\b(?:min|max)_element\s*(?1))\s*-\s*(?:\w+\s*\.\s*begin|(?:std\s*::\s*)?\bc?begin)\s*(?1)))",
     "*$3",
     "Minus begin() this is the place of the element, counted from 0: the element itself is *std::max_element(...)."},
    {"character", R"((?:\bchar\s+(?:(\w+)\b[^]*?\b\2)|\bstring\b[^]*?\[[^\]]*\])\s*-\s*([1-9])\b)", "'$3'",
     "A digit in a text is a character, which counts as another number ('0' as 48): subtract '$3', not $3.", 3},
    {"modulo_first", R"(((\b\w+)\s*\*\s*((?:\w+|(?1))\s*%\s*\w+)))", "$3 * ($4)",
     "* and % are computed from the left to the right: write `$3 * ($4)`."},
    {"uninitialized_variable", R"(\b(?:double|int|float)\s+(\w+)()\s*;(?=[^]*\b\2\s*[-+]=))", " = 0",
     "`$2` begins with no value, but is added to below: begin with 0.", 3},
    {"loop_step", R"(\bfor\s*\([^;]*;[^;]*;\s*((\w+)\s*\+=\s*[2-9])\s*\))", "++$3",
     "This loop leaves out every second turn, or more: write ++$3."},
    {"length_not_1", R"(\bAngleAxisd(?:\s+\w+)?\s*[({])" ANY R"(,()" PART R"()[)}])", "($3).normalized()",
     "AngleAxisd takes an axis of length 1: give it that of `normalized()`."},
    {"exact_comparison",
     R"((?:\bif\s*\(|\breturn\b|=|&&|\|\||\bwhile\s*\()\s*(([\w.\[\]]+(?1)?)\s*==\s*([\w.\[\]-]+))(?=\s*(?:\)|&&|\|\||\?|;)))",
     "[](auto x, auto y) { if constexpr (requires { std::abs(x - y) < 1e-9; }) return std::abs(x - y) < 1e-9; else "
     "return x == y; }($3, $4)",
     "Rounded numbers are hardly ever equal: compare std::abs of their difference with a small number."},
    {"line_twice", R"([;{})]\s*([^;{}=()]+(?1)?\s*[-+*/]?=[^;{}=]+;)(\s*\2))", "",
     "This statement stands twice, one after the other, and its effect is doubled: leave one out.", 3},
    {"bracket_too_early",
     R"(\b(?:sqrt|abs|sin|cos|tan|exp|log|a(?:sin|cos|tan))\s*\((((?:[^(){};,]|(?1))+)\)\s*([-+*/])\s*((?:[^(){};,+-]|(?1))+?))\s*[-+;,)])",
     "$3 $4 $5)", "The bracket of this function closes too early: what follows it belongs inside."},
    {"bracket_too_late",
     R"(\b(?:sqrt|abs|sin|cos|tan|exp|log|a(?:sin|cos|tan))\s*\((((?:[^(){};,]|(?1))+?)\s*([-+*/])\s*((?:[^(){};,+-]|(?1))+)\)))",
     "$3) $4 $5", "The bracket of this function closes too late: its last part belongs outside."},
    {"degrees", R"(((?:\s*\*\s*)" PI R"(\s*/\s*180(?:\.0*)?|\s*/\s*180(?:\.0*)?\s*\*\s*)" PI R"()(?![\w.])))", "",
     "This takes the angle for degrees, but it is in radians: leave the factor out."},
    {"degrees", R"((?<!/)(?<!/ )\b(180(?:\.0*)?)(?![\w.])(?!\s*[*/]\s*)" PI R"())", "3.14159265358979323846",
     "Sine, cosine and all angles are in radians here: 180° are std::numbers::pi."},
    {"break_for_continue", R"((\bbreak)\s*;(?![^]*\bswitch\b))", "continue",
     "break ends the whole loop; continue leaves out only the rest of this turn."},
    {"continue_for_break", R"((\bcontinue)\s*;)", "break",
     "continue leaves out only the rest of this turn; break ends the whole loop."},
    {"return_in_loop", R"(\belse\s*\{?\s*(return\b[^;{}]*;))", ";",
     "This return ends the loop in its first turn: it belongs after the loop."},
    {"end_of_range",
     R"(\b(?:sort|reverse|accumulate|(?:min|max)_element)\s*\(\s*(\w+)\s*(?:\+\s*\w+\s*)?,\s*\2\s*\+\s*\w+()\s*[,)])",
     " + 1", "A range ends one behind its last element: `$2 + 3` ends one with `$2[2]`.", 3},
    {"end_of_range", R"(\bend\s*\(\s*\w*\s*\)(\s*-\s*1)\s*[,)])", "",
     "A range ends one behind its last element, which is where end() is."},
    {"index_for_value", R"(\b(\w+)\s*\[\s*(\w+)\s*\]\s*[<>]=?\s*(\w+)\s*\)\s*\{?\s*\4\s*=\s*(\3)\s*;)", "$2[$3]",
     "This keeps the index of the element; the element itself is `$2[$3]`.", 5},
    {"index_for_value", R"(\b(\w+)\s*\[\s*(\w+)\s*\]\s*[<>]=?\s*(\w+)\s*\)\s*\{?\s*\4\s*=\s*\3\s*;)", "$2[$4]",
     "`$4` is the index of an element: compare with the element itself, `$2[$4]`.", 4},
    {"divided_in_loop", R"(\bfor\s*(?1)\s*\{[^{}]*?\b(\w+)\s*\+=[^{}]*?;\s*((\2\s*/=[^;{}=]+;)([^{}]*\})))", "$5 $4",
     "Every turn divides all of `$2` again: divide once, after the loop.", 3},
    {"changing_total",
     R"(((\bfor\s*(?1)\s*\{?\s*)(\w+\s*[\[(]\s*\w+\s*[\])])\s*([-*/]=)\s*(\w+)\s*\.\s*(mean|sum|norm|maxCoeff|minCoeff)\s*\(\s*\)))",
     "const auto workbook_total = $6.$7(); $3$4 $5 workbook_total",
     "Each turn computes `$6.$7()` anew, from entries that have changed by then: compute it once, before the loop."},
    {"and_for_or", R"(\s(&&)\s)", "||", "&& needs both sides to be true; here one of them is enough: write ||."},
    {"and_for_or", R"(\s(\|\|)\s)", "&&", "|| is true where one of both sides is; here both are needed: write &&."},
    {"difference_for_order",
     R"(\b(?:sort|stable_sort|nth_element|(?:min|max|minmax)_element|lower_bound|upper_bound)\s*\((?=[^;]*\{\s*return\b)[^;]*?\breturn\b[^;<>]*?(?<!return)(?<![(,=])\s(-)\s[^;<>]*;)",
     "<", "What says which comes first is true or false, and every number but 0 is true: write a < b."},
    {"loop_never_runs", BEGINS_AT_0 R"((?=[^]*\bwhile\s*\(\s*\2\s*>))", "HUGE_VAL",
     "With this 0 the condition of the loop is false at once, and it never runs: begin with infinity.", 3},
    {"extreme_from_zero", BEGINS_AT_0 R"((?=[^]*(?:\b\2\s*=\s*(?:std\s*::\s*)?min\s*\(|<\s*\2\b|\b\2\s*>)))",
     "HUGE_VAL",
     "No positive number is smaller than the 0 that `$2` begins with: begin with the first of them, or infinity.", 3},
    {"extreme_from_zero", BEGINS_AT_0 R"((?=[^]*(?:\b\2\s*=\s*(?:std\s*::\s*)?max\s*\(|>\s*\2\b|\b\2\s*<)))",
     "-HUGE_VAL",
     "No negative number is larger than the 0 that `$2` begins with: begin with the first of them, or -infinity.", 3},
    {"captured_value", R"([=(,{]\s*\[(=|\w+(?:\s*,\s*\w+)*)\]\s*[({])", "&",
     "This lambda keeps copies of variables as they are here, and does not see what they are given later: write [&].",
     2, true},
    {"rounded_counter",
     R"(\b(?:for\s*\([^;]*;|while\s*\()\s*(\w+)\s*<(?!=)\s*((?:[^(){};]|(?1))+?)()\s*[;)](?=[^]*?\b\2\s*\+=\s*([\w.]+)\s*[;)]))",
     " - $5 / 2",
     "`$2` is a sum of rounded steps, here a little below the end after the last one, and the loop makes one turn too "
     "many: count the turns by an int.",
     4},
    {"rounded_counter",
     R"(\b(?:for\s*\([^;]*;|while\s*\()\s*(\w+)\s*<=\s*((?:[^(){};]|(?1))+?)()\s*[;)](?=[^]*?\b\2\s*\+=\s*([\w.]+)\s*[;)]))",
     " + $5 / 2",
     "`$2` is a sum of rounded steps, here a little above the end after the last one, and the loop makes one turn too "
     "few: count the turns by an int.",
     4},
    {"other_method", R"(\.\s*(colwise)\s*\(\s*\)\s*\.\s*reverse\b)", "rowwise",
     "colwise().reverse() turns each column upside down; the order of the columns is reversed by rowwise()."},
    {"other_method", R"(\.\s*(rowwise)\s*\(\s*\)\s*\.\s*reverse\b)", "colwise",
     "rowwise().reverse() reverses the order of the columns; each column is turned upside down by colwise()."},
    {"other_method", R"(\.\s*(colwise)\s*\(\s*\)\s*\.\s*(?:sum|mean|prod|norm|squaredNorm|maxCoeff|minCoeff)\b)",
     "rowwise", "colwise() has a result for each column; that over all columns is rowwise()."},
    {"counts_from_one", R"(\.\s*(?:segment|middleCols|middleRows|col|row)\s*(?:<\s*\d\s*>\s*)?\(\s*(\d)\s*[,)])",
     "$2 - 1", "Indices start at 0: the first column is A.col(0), the first two entries are v.segment(0, 2).", 2, true},
    {"unsigned_number", R"(\b((?:std\s*::\s*)?size_t|unsigned(?:\s+(?:int|long))?)\s+(\w+)\s*[={,)])", "long",
     "An unsigned number is never negative, and wraps around to a very large one: make `$3`, and others like it, an "
     "int.",
     2, true},
    {"if_for_while", R"(\b(if)\s*\(\s*(\w+)\s*[<>][^;{}]*\)\s*\{?\s*\3\s*[-+*/]=)", "while",
     "This if is done once: a while goes on until its condition is false.", 2, true},
    {"other_method", R"(\.\s*(resize)\s*\()", "conservativeResize",
     "resize() drops what a matrix holds: give it its size before the loop, or use conservativeResize().", 2, true},
    {"arguments_of_atan2", R"(((?:std\s*::\s*)?\batan2)\s*\()", "[](auto x, auto y) { return std::atan2(y, x); }",
     "The y comes first in atan2(y, x): here the x is given first.", 2, true},
    {"rows_for_columns", R"(\.\s*(row)\s*\()", "col",
     "Here, and wherever else row() stands, col() is right: rows are mixed up with columns.", 2, true},
    {"rows_for_columns", R"(\.\s*(col)\s*\()", "row",
     "Here, and wherever else col() stands, row() is right: rows are mixed up with columns.", 2, true},
};

class Slips {
 public:
  Slips(const SourceText& source, const ExerciseReference& exercise) : source_(source) {
    for (Variant& each : one_token_variants(source, exercise)) of_variant(std::move(each));
    for (const Slip& slip : slip_table) of_table(slip);
    for (std::size_t k = 2; k + 2 < source.tokens().size(); ++k) {
      begins_anew(k);
      goes_on(k);
    }
    length_after_normalize();
    for (const Argument& argument : exercise.arguments)
      if (argument.kind == Kind::points)
        for (const auto& [method, what] : {std::pair{"size", "counts all entries"}, {"rows", "is 3"}})
          of_table({"size_for_columns", fmt::format(R"(\b{}\s*\.\s*({})\s*\()", argument.name, method).c_str(), "cols",
                    fmt::format("`{0}.{1}()` {2}: the number of columns is `{0}.cols()`.", argument.name, method, what)
                        .c_str(),
                    2, true});
    sizes_for_ends();
    entry_by_entry();
    macros();
  }

  std::vector<Reason> reasons;
  std::vector<Variant> variants;

 private:
  std::string_view token(std::size_t index) const {
    return index < source_.tokens().size() ? source_.tokens()[index].text : std::string_view();
  }
  bool is(std::size_t index, std::initializer_list<std::string_view> texts) const {
    return is_one_of(token(index), texts);
  }
  Edit replaced(std::size_t first, std::size_t last, std::string text) const {
    const std::size_t begin = source_.tokens()[first].offset;
    return {begin, source_.tokens()[last].offset + token(last).size() - begin, std::move(text)};
  }

  void add(const char* name, const std::string& sentence, Place place, std::vector<Edit> edits,
           Fix fix = Fix::when_all_right) {
    reasons.push_back(source_.reason(place, name, sentence, Weight::cause, fix));
    variants.push_back({VariantKind::fix, name, place, std::move(edits)});
  }
  void add(const char* name, const std::string& sentence, std::size_t at, std::vector<Edit> edits) {
    add(name, sentence, source_.place_of(source_.tokens()[at].offset), std::move(edits));
  }

  void of_table(const Slip& slip) {
    std::vector<Edit> edits;
    std::string sentence;
    Place place;
    for (const Match& read : search_all(source_.text(), brackets + std::string(slip.pattern))) {
      if (edits.empty()) {
        sentence = read.fill(slip.sentence);
        place = source_.place_of(read.offsets[slip.group]);
      }
      edits.push_back({read.offsets[slip.group], read[slip.group].size(), read.fill(slip.change)});
      if (!slip.everywhere) add(slip.name, sentence, place, std::exchange(edits, {}));
    }
    if (!edits.empty()) add(slip.name, sentence, place, std::move(edits));
  }
  void of_variant(Variant each) {
    const auto tell = [&](const char* name, const std::string& sentence, Fix fix = Fix::when_all_right) {
      add(name, sentence, each.place, std::move(each.edits), fix);
    };
    if (each.kind == VariantKind::division && each.words.empty())
      tell("integer_division",
           "Whole numbers are divided here, and what follows the decimal point is dropped: make one of them a double.",
           Fix::real_quotient);
    else if (each.kind == VariantKind::division)
      tell("divisor", "a / b * c is (a / b) * c: to divide by the product, write a / (b * c).");
    else if (each.words == brackets_before_method_words)
      tell("method_brackets",
           "A method belongs to what stands directly before its dot, and comes before * and +: put brackets around all "
           "that it is meant for.");
    else if (each.words == brackets_around_choice_words)
      tell("choice_brackets", "? and : come after * and + and comparisons: put brackets around all of a ? b : c.");
    else if (each.kind == VariantKind::overwritten && is_used_in_next_statement(each))
      tell("overwritten",
           "The line above has changed this variable, and here the value from before is needed: keep that in a "
           "variable of its own. (std::swap exchanges two values.)");
  }

  /// x = c * x - s * y; y = s * x + c * y; and x = y; y = x;
  bool is_used_in_next_statement(const Variant& variant) const {
    const std::size_t begin = variant.edits[0].offset, use = variant.edits[1].offset;
    const std::string_view between = source_.text().substr(begin, use - begin);
    const std::string_view name = source_.text().substr(use, variant.edits[1].length);
    return std::ranges::count(between, ';') == 1 && (between.find(name, name.size()) < between.find(';') ||
                                                     search(between, R"(=\s*([^;=]+?)\s*;\s*\1\s*=\s*$)"));
  }

  /// double sum = 0; for (…) { for (…) sum += …; R(i, j) = sum; }: what is declared before a loop and only added to in
  /// it
  void begins_anew(std::size_t head) {
    const std::size_t body =
        is(head, {"for", "while"}) && token(head + 1) == "(" ? source_.partner_of(head + 1) + 1 : 0;
    if (body == 0 || token(body) != "{") return;
    const std::size_t end = source_.partner_of(body);
    std::map<std::string, Edit> resets;
    std::set<std::string> set_here;  // they begin anew
    for (std::size_t k = body + 1; k < end; ++k) {
      if (is(k - 1, {".", "->", "::"}) || token(k).empty() ||
          std::isalpha(static_cast<unsigned char>(token(k)[0])) == 0)
        continue;
      const std::string name(token(k));
      if (token(k + 1) == "=") set_here.insert(name);
      std::size_t sign = k + 1;
      while (is(sign, {"(", "["})) sign = source_.partner_of(sign) + 1;
      if (is(sign, {"+=", "-="}))
        if (const std::string first = first_value(name, head); first.starts_with('0') || first.ends_with("Zero()"))
          resets[name] = {source_.tokens()[body].offset + 1, 0, fmt::format(" {} = {};", name, first)};
    }
    for (const std::string& name : set_here) resets.erase(name);
    for (const auto& [name, edit] : resets)
      add("sum_that_goes_on",
          fmt::format("`{}` still holds what the turns of this loop before have added: let it begin anew in each.",
                      name),
          body, {edit});
    if (resets.size() < 2) return;
    Edit all{source_.tokens()[body].offset + 1, 0, ""};
    std::string names;
    for (const auto& [name, edit] : resets) {
      all.replacement += edit.replacement;
      names += fmt::format("{}`{}`", names.empty() ? "" : ", ", name);
    }
    add("sum_that_goes_on",
        fmt::format("{} still hold what the turns of this loop before have added: let them begin anew in each.", names),
        head, {all});
  }
  /// while (…): its condition says when to go on, and something in it has to change.
  void goes_on(std::size_t head) {
    if (token(head) != "while" || token(head + 1) != "(") return;
    const std::size_t close = source_.partner_of(head + 1);
    const bool is_behind = token(close + 1) == ";";  // do { … } while (…);
    const std::size_t open = is_behind ? source_.partner_of(head - 1) : close + 1;
    if (token(open) != "{") return;
    for (std::size_t k = head + 2; k + 3 < close; ++k) {
      if (token(k) != "abs" || token(k + 1) != "(" || token(k + 3) != "-" || token(k + 5) != ")") continue;
      std::string last(token(k + 2)), before(token(k + 4));
      if (!is_set(last, open)) std::swap(last, before);
      // Two that are both set may be equal too early, and then another comparison only goes on for ever.
      if (is_set(last, open) && is_set(before, open)) return;
      if (is_set(last, open))
        add("never_taken_over",
            fmt::format("`{}` keeps its value in this loop: give it that of `{}` before the next one is computed.",
                        before, last),
            head, {{source_.tokens()[open].offset + 1, 0, fmt::format(" {} = {};", before, last)}});
    }
    for (std::size_t k = head + 2; k < close; ++k)
      if (is(k, {"<", "<=", ">", ">="}))
        return add("loop_condition",
                   "The loop goes on as long as this is true, and not until it is: turn the comparison round.", k,
                   {replaced(k, k, token(k)[0] == '<' ? ">" : "<")});
  }
  bool is_set(const std::string& name, std::size_t open) const {
    for (std::size_t k = open; k < source_.partner_of(open); ++k)
      if (token(k) == name && is(k + 1, {"=", "+=", "-=", "*=", "/="})) return true;
    return false;
  }

  /// What is declared before, as in `double sum = 0, product = 1;`; nothing where it has no value.
  std::string first_value(const std::string& name, std::size_t before) const {
    for (std::size_t k = before; k-- > 2;) {
      if (token(k) != name || token(k + 1) != "=" || is(k - 1, {".", "::", ";", "{", "}", ")"})) continue;
      std::size_t last = k + 2;
      while (!is(last + 1, {",", ";", ""})) last = opens(token(last + 1)) ? source_.partner_of(last + 1) : last + 1;
      const std::size_t begin = source_.tokens()[k + 2].offset;
      return std::string(source_.text().substr(begin, source_.tokens()[last].offset + token(last).size() - begin));
    }
    return "";
  }

  /// L.normalize(); … L.norm()
  void length_after_normalize() {
    for (const Match& changed : search_all(source_.text(), R"(\b(\w+)\s*\.\s*normalize\s*\(\s*\)\s*;)")) {
      const std::string length = "workbook_length_of_" + changed[1];
      std::vector<Edit> edits = {
          {changed.offsets[0], 0, fmt::format("const double {} = {}.norm(); ", length, changed[1])}};
      for (const Match& read : search_all(source_.text(), R"(\b)" + changed[1] + R"(\s*\.\s*norm\s*\(\s*\))"))
        if (read.offsets[0] > changed.offsets[0]) edits.push_back({read.offsets[0], read[0].size(), length});
      if (edits.size() < 2) continue;
      const Place place = source_.place_of(edits[1].offset);
      add("length_after_normalize",
          fmt::format("normalize() has changed `{}` itself, whose length is 1 from there on: keep its length before.",
                      changed[1]),
          place, std::move(edits));
    }
  }

  /// v.segment(from, to), A.middleCols(from, to) and A.block(row, column, to row, to column), with or without that end
  void sizes_for_ends() {
    for (const char* more : {"", " + 1"}) {
      std::vector<Edit> edits;
      std::string method;
      for (const Match& read : search_all(
               source_.text(), brackets + R"(\.\s*(segment|middleCols|middleRows)\s*\()" PART "," PART R"(\))")) {
        method = read[2];
        edits.push_back({read.offsets[4], read[4].size(), fmt::format("{} - ({}){}", read[4], read[3], more)});
      }
      for (const Match& read :
           search_all(source_.text(), brackets + R"(\.\s*(block)\s*\()" PART "," PART "," PART "," PART R"(\))")) {
        method = read[2];
        for (const std::size_t k : {5, 6})
          edits.push_back({read.offsets[k], read[k].size(), fmt::format("{} - ({}){}", read[k], read[k - 2], more)});
      }
      if (edits.empty()) continue;
      const Place place = source_.place_of(edits[0].offset);
      const char* shown = method == "block" ? "row, column, how many rows, how many columns" : "first, how many";
      add("size_for_end", fmt::format("{0}() takes sizes, and not ends: {0}({1}).", method, shown), place,
          std::move(edits));
    }
  }

  /// A.cwiseProduct(v) and A.array() * B.array() for A * v and A * B
  void entry_by_entry() {
    for (const Match& read : search_all(source_.text(), R"(\b(\w+)(\s*\.\s*cwiseProduct)\s*\()"))
      if (search(source_.text(), R"(\bMatrix3d\s*&?\s*)" + read[1] + R"(\b)"))
        add("entrywise_product", "cwiseProduct() multiplies entry by entry; the product of matrices is A * B.",
            source_.place_of(read.offsets[2]), {{read.offsets[2], read[2].size(), " * "}});
    std::vector<Edit> edits;
    for (const Match& read : search_all(source_.text(), R"(\.\s*(?:array|matrix)\s*\(\s*\))"))
      edits.push_back({read.offsets[0], read[0].size(), ""});
    const std::size_t calls = edits.size();
    for (const Match& read : search_all(source_.text(), R"(\bArray(?:3(?=3d\b)|X(?=Xd\b)|(?=3Xd\b)))"))
      edits.push_back({read.offsets[0], read[0].size(), "Matrix"});
    if (calls == 0) return;
    const Place place = source_.place_of(edits[0].offset);
    add("entrywise_product", "The * of arrays multiplies entry by entry: leave .array() out for a product of matrices.",
        place, std::move(edits));
  }

  /// #define SQUARE(x) x * x
  void macros() {
    constexpr const char* pattern =
        R"((?:^|\n)[ \t]*#[ \t]*define[ \t]+(\w+)(\([\w, \t]+\)|)[ \t]+((?:[^\n/]|/(?!/))*[-+*/](?:[^\n/]|/(?!/))*))";
    for (const Match& defined : search_all(source_.text(), pattern)) {
      std::string text = defined[3];
      for (const Match& name : search_all(defined[2], "\\w+"))
        text = workbook::replaced(text, "\\b" + name[0] + "\\b", "(" + name[0] + ")");
      add("macro",
          defined.fill("The text of `$1` is put in as it stands, so that * and / before it or + in it take it apart: "
                       "write a function or a constant in its place."),
          source_.place_of(defined.offsets[1]), {{defined.offsets[3], defined[3].size(), "(" + text + ")"}});
    }
  }

  const SourceText& source_;
};

#undef ANY
#undef PART
#undef COMPARISON
#undef BEGINS_AT_0
#undef PI

}  // namespace

std::pair<std::vector<Reason>, std::vector<Variant>> slips_of_language(const SourceText& source,
                                                                       const ExerciseReference& exercise) {
  Slips slips(source, exercise);
  return {std::move(slips.reasons), std::move(slips.variants)};
}

}  // namespace workbook
