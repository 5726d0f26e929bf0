// Read by Eigen itself, inside its namespaces and before the headers that eigen_facts.hpp knows
// (EIGEN_FUNCTORS_PLUGIN): gives the conditions that begin with EIGEN_IMPLIES a first word.
#undef EIGEN_IMPLIES
#define EIGEN_IMPLIES(a, b) workbook_implies(a, b)
