#include <cmath>
#include <rigid/measured.hpp>
Vector2d mean_and_error(const VectorXd& values) {
//! right: loops
  double mean = 0, sum = 0;
  for (double x : values) mean += x;
  mean /= values.size();
  for (double x : values) sum += (x - mean) * (x - mean);
  return {mean, std::sqrt(sum / (values.size() - 1) / values.size())};
//! wrong: scatter of one value
  const double mean = values.mean();
  return {mean, std::sqrt((values.array() - mean).square().sum() / (values.size() - 1))};
//! wrong: population variance
  const double mean = values.mean();
  return {mean, std::sqrt((values.array() - mean).square().mean() / values.size())};
//! wrong: mean absolute deviation
  const double mean = values.mean();
  return {mean, (values.array() - mean).abs().mean() / std::sqrt(values.size())};
