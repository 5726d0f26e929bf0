#include "checker/judging/sampling.hpp"

#include <algorithm>
#include <numeric>

namespace workbook {

std::vector<std::size_t> spread(const std::vector<std::size_t>& items, std::size_t count) {
  if (items.size() <= count) return items;
  if (count == 1) return {items.front()};
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < count; ++k) chosen.push_back(items[k * (items.size() - 1) / (count - 1)]);
  return chosen;
}

std::vector<std::size_t> plan_repeats(const ExerciseReference& exercise) {
  std::vector<std::size_t> all(exercise.cases.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<std::size_t> chosen = spread(all, 3);
  std::ranges::reverse(chosen);
  return chosen;
}

}  // namespace workbook
