/// @file
/// An `eigen_assert` that also tells the indices and sizes at the place where it fails. To be included before Eigen.
///
/// Which names hold them differs from place to place: `row` and `rows()` in `A(i, j)`, `startRow` and `xpr` in a block.
/// The condition's first word tells the place: joined to WORKBOOK_FACTS_ it is a macro that names the facts, or, where
/// nothing is known, no macro at all. Joining does not work where a condition begins with `!` or a parenthesis, so it
/// is only done between headers of Eigen that are known for it; their include guards say which have been read.
///
/// Facts are a luxury: in a version of Eigen with other names the conditions still fail as they should, without sizes.
#pragma once

#include "facts.hpp"

namespace Eigen {

/// EIGEN_IMPLIES as a word, so that the conditions which begin with it can be told.
constexpr bool workbook_implies(bool condition, bool consequence) { return !condition || consequence; }

}  // namespace Eigen

#define WORKBOOK_JOIN(a, b) WORKBOOK_JOIN_AS_IS(a, b)
#define WORKBOOK_JOIN_AS_IS(a, b) a##b
#define WORKBOOK_SECOND(...) WORKBOOK_SECOND_AS_IS(__VA_ARGS__)
#define WORKBOOK_SECOND_AS_IS(first, second, ...) second
#define WORKBOOK_FIRST(...) WORKBOOK_FIRST_AS_IS(__VA_ARGS__, )
#define WORKBOOK_FIRST_AS_IS(first, ...) first

// 1 if the header with this include guard has been begun, else 0.
#define WORKBOOK_SEEN(guard) WORKBOOK_SECOND(WORKBOOK_JOIN(WORKBOOK_UNSEEN_, guard), 1, )
#define WORKBOOK_UNSEEN_EIGEN_DENSECOEFFSBASE_H , 0
#define WORKBOOK_UNSEEN_EIGEN_BLOCK_H , 0
#define WORKBOOK_UNSEEN_EIGEN_VECTORBLOCK_H , 0
#define WORKBOOK_UNSEEN_EIGEN_COMMAINITIALIZER_H , 0
#define WORKBOOK_UNSEEN_EIGEN_GENERAL_PRODUCT_H , 0
#define WORKBOOK_UNSEEN_EIGEN_TRIANGULARMATRIX_H , 0

// 1 if the condition begins with a parenthesis, else 0.
#define WORKBOOK_IN_PARENTHESES(condition) WORKBOOK_SECOND(WORKBOOK_PARENTHESES condition, 0, )
#define WORKBOOK_PARENTHESES(...) , 1,
#define WORKBOOK_CONTENT_OF(condition) WORKBOOK_FIRST(WORKBOOK_CONTENT condition)
#define WORKBOOK_CONTENT(...) __VA_ARGS__,

// Where Eigen is being read: outside all known headers, in general, in Block.h, in CommaInitializer.h.
#define WORKBOOK_FACTS_OF(condition)                                                                                 \
  WORKBOOK_JOIN(                                                                                                     \
      WORKBOOK_FACTS_AT_,                                                                                            \
      WORKBOOK_JOIN(                                                                                                 \
          WORKBOOK_JOIN(WORKBOOK_JOIN(WORKBOOK_SEEN(EIGEN_DENSECOEFFSBASE_H), WORKBOOK_SEEN(EIGEN_BLOCK_H)),         \
                        WORKBOOK_JOIN(WORKBOOK_SEEN(EIGEN_VECTORBLOCK_H), WORKBOOK_SEEN(EIGEN_COMMAINITIALIZER_H))), \
          WORKBOOK_JOIN(WORKBOOK_SEEN(EIGEN_GENERAL_PRODUCT_H), WORKBOOK_SEEN(EIGEN_TRIANGULARMATRIX_H))))           \
  (condition)
#define WORKBOOK_FACTS_AT_000000(condition) WORKBOOK_NO_FACTS
#define WORKBOOK_FACTS_AT_100000(condition) WORKBOOK_FACTS_BY_WORD(condition)
#define WORKBOOK_FACTS_AT_110000(condition) WORKBOOK_FACTS_IN_BLOCK(condition)
#define WORKBOOK_FACTS_AT_111000(condition) WORKBOOK_FACTS_BY_WORD(condition)
#define WORKBOOK_FACTS_AT_111100(condition) \
  ::workbook::facts(m_row, m_col, m_currentBlockRows, m_xpr.rows(), m_xpr.cols())
#define WORKBOOK_FACTS_AT_111110(condition) WORKBOOK_FACTS_BY_WORD(condition)
#define WORKBOOK_FACTS_AT_111111(condition) WORKBOOK_NO_FACTS

#define WORKBOOK_NO_FACTS ::workbook::facts()
#define WORKBOOK_FACTS_BY_WORD(condition) \
  WORKBOOK_JOIN(WORKBOOK_FACTS_BY_WORD_, WORKBOOK_IN_PARENTHESES(condition))(condition)
#define WORKBOOK_FACTS_BY_WORD_0(condition) WORKBOOK_SECOND(WORKBOOK_FACTS_##condition, WORKBOOK_NO_FACTS, )
#define WORKBOOK_FACTS_BY_WORD_1(condition) WORKBOOK_NO_FACTS
#define WORKBOOK_FACTS_IN_BLOCK(condition) \
  WORKBOOK_JOIN(WORKBOOK_FACTS_IN_BLOCK_, WORKBOOK_IN_PARENTHESES(condition))(condition)
#define WORKBOOK_FACTS_IN_BLOCK_0(condition) WORKBOOK_FACTS_BY_WORD_0(condition)
#define WORKBOOK_FACTS_IN_BLOCK_1(condition) \
  WORKBOOK_SECOND(WORKBOOK_JOIN(WORKBOOK_FACTS_BLOCK_, WORKBOOK_CONTENT_OF(condition)), WORKBOOK_NO_FACTS, )

// The facts, by the first word of the condition. checker/messages/running.cpp reads them in this order.
#define WORKBOOK_FACTS_index , ::workbook::facts(index, size()),
#define WORKBOOK_FACTS_row , ::workbook::facts(row, col, rows(), cols()),
#define WORKBOOK_FACTS_lhs , ::workbook::facts(lhs.rows(), lhs.cols(), rhs.rows(), rhs.cols()),
#define WORKBOOK_FACTS_aLhs , ::workbook::facts(aLhs.rows(), aLhs.cols(), aRhs.rows(), aRhs.cols()),
#define WORKBOOK_FACTS_dst , ::workbook::facts(dst.rows(), dst.cols(), src.rows(), src.cols()),
#define WORKBOOK_FACTS_size() , ::workbook::facts(size(), other.size()),
#define WORKBOOK_FACTS_workbook_implies(...) \
  , ::workbook::facts(rows, cols, Eigen::Index(RowsAtCompileTime), Eigen::Index(ColsAtCompileTime)),
#define WORKBOOK_FACTS_startRow \
  , ::workbook::facts(startRow, startCol, this->rows(), this->cols(), xpr.rows(), xpr.cols()),
#define WORKBOOK_FACTS_a_index , ::workbook::facts(a_index, m_matrix.rows(), m_matrix.cols()),
#define WORKBOOK_FACTS_BLOCK_i \
  , ::workbook::facts(i, xpr.rows(), xpr.cols(), Eigen::Index(BlockRows), Eigen::Index(BlockCols)),

#define eigen_assert(condition, ...)      \
  ((condition __VA_OPT__(, ) __VA_ARGS__) \
       ? static_cast<void>(0)             \
       : ::workbook::report_eigen_assertion(#condition __VA_OPT__("," #__VA_ARGS__), WORKBOOK_FACTS_OF(condition)))
