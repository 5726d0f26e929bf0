#include "solutions/judging/exercise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace workbook::judging {

namespace detail {

template <class T>
Value to_value(const T& typed) {
  Value value{KindOf<T>::rows(typed), KindOf<T>::cols(typed), {}};
  value.numbers.resize(static_cast<std::size_t>(value.rows) * value.cols);
  KindOf<T>::write(typed, value.numbers.data());
  return value;
}

template <class T>
T from_value(const Value& value) {
  return KindOf<T>::read({value.rows, value.cols, value.numbers.data()});
}

/// Makes both for all types of the contracts.
template <class... T>
struct Made {
  static inline const std::tuple all{&to_value<T>..., &from_value<T>...};
};
template struct Made<double, int, Vector2d, Vector3d, VectorXd, Matrix3d, Matrix3Xd, std::vector<Matrix3d>>;

}  // namespace detail

namespace {

/// "Matrix3d inertia_of_points(const VectorXd& m, const Matrix3Xd& r)".
std::string signature_of(const ExerciseReference& exercise) {
  constexpr const char* types[] = {"double",   "int",      "Vector2d",  "Vector3d",  // in the order of Kind
                                   "VectorXd", "Matrix3d", "Matrix3Xd", "std::vector<Matrix3d>"};
  std::vector<std::string> parameters;
  for (const auto& [name, kind, unit] : exercise.arguments) {
    const bool by_value = kind == Kind::number || kind == Kind::integer;
    const std::string type = types[static_cast<int>(kind)];
    parameters.push_back(fmt::format("{} {}", by_value ? type : fmt::format("const {}&", type), name));
  }
  return fmt::format("{} {}({})", types[static_cast<int>(exercise.result_kind)], exercise.name,
                     fmt::join(parameters, ", "));
}

/// A seed of its own for every batch of random cases, so that adding one leaves the others as they were.
std::uint64_t batch_seed(std::uint64_t seed, const std::string& exercise, const std::string& batch) {
  // FNV-1a: a hash that is the same on every machine, unlike std::hash.
  std::uint64_t hash = 0xcbf29ce484222325ULL ^ seed;
  for (const char letter : fmt::format("{}/{}", exercise, batch))
    hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
  return hash;
}

constexpr std::uint64_t first_seed = 1;

double largest(const Value& value) { return as_matrix(value).lpNorm<Eigen::Infinity>(); }

/// Finite, and neither products nor quotients of such numbers overflow or underflow.
bool has_ordinary_size(double number) { return number == 0 || (std::abs(number) > 1e-100 && std::abs(number) < 1e100); }

void append(std::string& reasons, std::string_view reason) {
  if (!reasons.empty()) reasons += ' ';
  reasons += reason;
}

/// The outputs of the functions at these inputs, each to its part.
template <class Part>
void add_outputs(std::vector<Part>& parts, const std::vector<OnValues<Value>>& functions, const Values& inputs,
                 std::vector<Value> Part::*outputs) {
  for (std::size_t k = 0; k < functions.size(); ++k) (parts[k].*outputs).push_back(functions[k](inputs));
}

}  // namespace

void AnyExercise::set_signature(const std::vector<Named>& arguments, const std::vector<const char*>& kinds,
                                const Named& result, const char* result_kind) {
  if (arguments.size() != kinds.size())
    throw std::logic_error(result_.name + ": every parameter of the contract needs a name and a unit");
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    sorts_.push_back(arguments[i].sort);
    result_.arguments.push_back({arguments[i].name, kind_from_string(kinds[i]), arguments[i].sort.unit});
  }
  result_.result_kind = kind_from_string(result_kind);
  result_.result_name = result.name;
  result_.result_units = {result.sort.unit};
  result_.signature = signature_of(result_);
}

AnyExercise::Function AnyExercise::remembering(Function function) {
  const auto known = std::make_shared<std::map<std::string, Value>>();
  return [function = std::move(function), known](const Values& inputs) {
    std::string key;  // the bytes, for a NaN is equal to nothing
    for (const Value& input : inputs) {
      key.append(reinterpret_cast<const char*>(&input.cols), sizeof input.cols);
      key.append(reinterpret_cast<const char*>(input.numbers.data()), input.numbers.size() * sizeof(double));
    }
    if (const auto found = known->find(key); found != known->end()) return found->second;
    return known->emplace(std::move(key), function(inputs)).first->second;
  };
}

void AnyExercise::survivor(std::string_view bug, std::string_view reason) {
  result_.survivor_reasons[std::string(bug)] = reason;
}

void AnyExercise::tolerance(double relative, std::string_view reason) {
  for (Batch& batch : batches_) batch.prototype.tolerance = relative;
  append(result_.tolerance_reason, reason);
}

void AnyExercise::tolerance_of_last_case(double relative, std::string_view reason) {
  batches_.back().prototype.tolerance = relative;
  append(result_.tolerance_reason, reason);
}

void AnyExercise::wrong_terms(Sentence says, std::string_view name, const Doubles& coefficients) {
  if (coefficients.size() != terms_.size())
    throw std::logic_error(fmt::format("{}, {}: give one coefficient for every term declared", result_.name, name));
  add_wrong(says, name, [terms = terms_, coefficients](const Values& inputs) {
    Eigen::MatrixXd sum = coefficients[0] * as_matrix(terms[0](inputs));
    for (std::size_t k = 1; k < terms.size(); ++k) sum += coefficients[k] * as_matrix(terms[k](inputs));
    return to_value(sum);
  });
}

void AnyExercise::property(PropertyKind kind, Sentence says, int argument) {
  result_.properties.push_back({kind, says.text, says.notes, argument, {}});
  weights_.emplace_back();
}

void AnyExercise::is_inertia_tensor(const char* symmetry_notes, const char* energy_notes) {
  property(Is::symmetric, {"An inertia tensor is symmetric.", symmetry_notes});
  property(Is::positive_semidefinite,
           {"An inertia tensor has no negative eigenvalue: no rotation has negative energy.", energy_notes});
}

void AnyExercise::add_batch(std::string_view name, Group group, int count, std::function<Values(Random&)> draw) {
  Case prototype;
  prototype.name = name;
  prototype.group = group;
  prototype.deciding = group != Group::special;
  batches_.push_back({std::move(prototype), count, std::move(draw)});
}

void AnyExercise::add_fixed(std::string_view name, Group group, Values inputs) {
  if (first_case_.empty()) first_case_ = inputs;
  add_batch(name, group, 1, [inputs = std::move(inputs)](Random&) { return inputs; });
}

void AnyExercise::add_limit(std::string_view of_case, Value expected, std::string_view reason) {
  limits_.push_back({std::string(of_case), std::move(expected), std::string(reason)});
}

void AnyExercise::add_region(const char* words, OnValues<bool> holds) {
  result_.regions.push_back({words, {}});
  regions_.push_back(std::move(holds));
}

void AnyExercise::add_wrong(Sentence says, std::string_view name, Function wrong) {
  result_.misconceptions.push_back({std::string(name), says.text, says.notes, {}, {}});
  misconceptions_.push_back(std::move(wrong));
}

void AnyExercise::add_term(std::string_view name, double coefficient, Function summand) {
  result_.terms.push_back({std::string(name), coefficient, {}});
  terms_.push_back(std::move(summand));
}

void AnyExercise::add_route(std::string_view name, Function other) {
  result_.routes.push_back({std::string(name), {}});
  routes_.push_back(std::move(other));
}

void AnyExercise::add_measured(std::string_view name, Doubles errors, Values inputs) {
  result_.measured.push_back({std::string(name), std::move(inputs), std::move(errors)});
}

void AnyExercise::set_scale(double size) {
  scale_ = [size](const Values&) { return Doubles{size}; };
}

void AnyExercise::set_sweep(const SweepLabels& labels, const std::vector<Drawn>& components, SweepRange range,
                            std::function<Values(double)> inputs_at) {
  result_.sweep = {labels.title, labels.x, labels.y, {}, {}, {}, {}, labels.y_unit};
  for (const Drawn& each : components) {
    const int place = static_cast<int>(result_.sweep.components.size());
    result_.sweep.components.push_back({each.name, each.row < 0 ? place : each.row, each.col});
  }
  sweep_range_ = range;
  sweep_inputs_ = std::move(inputs_at);
}

bool AnyExercise::is_legal(const Values& inputs) const {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!std::ranges::all_of(inputs[i].numbers, has_ordinary_size)) return false;
    if (sorts_[i].is_legal && !sorts_[i].is_legal(inputs[i])) return false;
  }
  return !domain_ || domain_(inputs);
}

Case AnyExercise::case_at(Case judged) const {
  const Values& inputs = judged.inputs;
  const std::string place = result_.name + ", case '" + judged.name + "'";
  if (!is_legal(inputs)) throw std::logic_error(place + ": the input lies outside the domain of the contract");
  judged.expected = reference_(inputs);
  const Doubles of_base = std::move(judged.scale);
  if (scale_) {
    judged.scale = scale_(inputs);
  } else {
    judged.scale = {largest(judged.expected)};
    for (std::size_t k = 0; k < terms_.size(); ++k)
      judged.scale[0] = std::max(judged.scale[0], std::abs(result_.terms[k].coefficient) * largest(terms_[k](inputs)));
  }
  if (!of_base.empty()) {
    const double least = 64 * std::numeric_limits<double>::epsilon() / judged.tolerance;
    bool says_something = false;
    for (std::size_t n = 0; n < judged.scale.size(); ++n) {
      const double rounding = least * of_base[std::min(n, of_base.size() - 1)];
      says_something = says_something || judged.tolerance * rounding < 1e-3 * judged.scale[n];
      judged.scale[n] = std::max(judged.scale[n], rounding);
    }
    if (!says_something) throw std::logic_error(place + ": the result is lost in the rounding of its parts");
  }
  if (!judged.expected.is_finite())
    throw std::logic_error(place + ": the reference solution gives a number that is not finite");
  if (judged.scale.size() != 1 && judged.scale.size() != judged.expected.numbers.size())
    throw std::logic_error(place + ": give one scale, or one for each number of the result");
  for (const double scale : judged.scale) {
    if (!(scale > 0) || !std::isfinite(scale))
      throw std::logic_error(place + ": the expected result is zero, so say its natural scale with scale(...)");
  }
  return judged;
}

void AnyExercise::add_case(const Case& one, ExerciseReference& out) const {
  out.cases.push_back(case_at(one));
  out.cases.back().condition = condition_of(out.cases.back(), out, reference_);
  add_outputs(out.terms, terms_, one.inputs, &Term::outputs);
  add_outputs(out.misconceptions, misconceptions_, one.inputs, &Misconception::outputs);
  add_outputs(out.routes, routes_, one.inputs, &Route::outputs);
}

Subject AnyExercise::subject_of(const ExerciseReference& out) const {
  const auto legal = [this](const Values& inputs) { return is_legal(inputs) && (!moderate_ || moderate_(inputs)); };
  return {out, reference_, routes_, legal, [this](Case candidate) {
            candidate.group = Group::generated;
            candidate.deciding = false;
            candidate.tolerance = batches_.back().prototype.tolerance;
            return case_at(std::move(candidate));
          }};
}

void AnyExercise::add_sweep(ExerciseReference& out) const {
  for (int i = 0; sweep_inputs_ && i < sweep_range_.points; ++i) {
    const double x = sweep_range_.from + (sweep_range_.to - sweep_range_.from) * i / (sweep_range_.points - 1);
    const Values inputs = sweep_inputs_(x);
    if (!is_legal(inputs)) continue;
    out.sweep.x.push_back(x);
    out.sweep.inputs.push_back(inputs);
    out.sweep.expected.push_back(reference_(inputs));
    add_outputs(out.misconceptions, misconceptions_, inputs, &Misconception::sweep_outputs);
  }
}

void AnyExercise::check_limit(const Foreseen& limit, ExerciseReference& out) const {
  const std::string place = fmt::format("{}, limit '{}': ", out.name, limit.of_case);
  const auto found = std::ranges::find(out.cases, limit.of_case, &Case::name);
  if (found == out.cases.end()) throw std::logic_error(place + "there is no such case");
  const std::vector<double>&right = found->expected.numbers, &foreseen = limit.expected.numbers;
  constexpr double by_hand = 5e-3;  // what predict takes for right
  bool agrees = found->expected.has_shape_of(limit.expected);
  for (std::size_t n = 0; agrees && n < right.size(); ++n)
    agrees = std::abs(right[n] - foreseen[n]) <= by_hand * found->scale[std::min(n, found->scale.size() - 1)];
  if (!agrees)
    throw std::logic_error(place + fmt::format("the solution gives {}, not {}",
                                               format_value(found->expected, out.result_kind, 6),
                                               format_value(limit.expected, out.result_kind, 6)));
  out.limits.push_back({static_cast<std::size_t>(found - out.cases.begin()), limit.reason});
}

void AnyExercise::add_cases(const Batch& batch, std::uint64_t seed, ExerciseReference& out) const {
  Random random(batch_seed(seed, out.name, batch.prototype.name));
  for (int i = 1; i <= batch.count; ++i) {
    Case one = batch.prototype;
    if (batch.count > 1) one.name += " " + std::to_string(i);
    one.inputs = batch.draw(random);
    add_case(one, out);
  }
}

ExerciseReference AnyExercise::random_cases(std::uint64_t seed) const {
  ExerciseReference out = result_;
  out.properties.clear();  // they are told of all cases, as regions are
  out.regions.clear();
  for (const Batch& batch : batches_)
    if (batch.prototype.group == Group::random) add_cases(batch, seed, out);
  return out;
}

ExerciseReference AnyExercise::described(std::uint64_t seed) const {
  ExerciseReference out = result_;
  for (Case& one : ladder(subject_of(out))) {
    one.group = Group::special;
    add_case(one, out);
  }
  for (const Batch& batch : batches_) add_cases(batch, seed, out);
  return out;
}

ExerciseReference AnyExercise::evaluate(std::uint64_t seed, const Adequacy& recorded,
                                        const std::vector<Subject>& others) const {
  ExerciseReference out = described(seed);
  const Subject subject = subject_of(out);
  std::vector<Case> generated = corner_cases(subject);
  std::ranges::move(neighbour_cases(subject, recorded.neighbours), std::back_inserter(generated));
  out.adequacy = recorded;
  // Cases of other seeds differ from those on record.
  out.has_current_adequacy = seed != first_seed || recorded.fingerprint == fingerprint_of(subject, recorded);
  out.input_transforms = input_transforms(subject, others);
  std::ranges::move(generated, std::back_inserter(out.cases));
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    if (!weights_[k]) continue;
    for (const Case& one : out.cases) out.properties[k].weights.push_back(weights_[k](one.inputs));
  }
  add_sweep(out);
  for (std::size_t k = 0; k < regions_.size(); ++k) {
    for (const Case& one : out.cases) out.regions[k].holds.push_back(regions_[k](one.inputs));
    for (const Values& inputs : out.sweep.inputs) out.regions[k].holds.push_back(regions_[k](inputs));
  }
  for (const Foreseen& limit : limits_) check_limit(limit, out);
  for (const Measured& real : out.measured)
    if (!is_legal(real.inputs) || !reference_(real.inputs).is_finite())
      throw std::logic_error(out.name + ": " + real.name + " lies outside the domain of the contract");
  return out;
}

Adequacy AnyExercise::prove(std::uint64_t seeds, Adequacy record) const {
  for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
    const ExerciseReference exercise = described(seed);
    const Subject subject = subject_of(exercise);
    std::vector<Case> cases = corner_cases(subject);
    std::ranges::move(neighbour_cases(subject, record.neighbours), std::back_inserter(cases));
    Adequacy found = prove_adequacy(subject, std::move(cases));
    std::ranges::move(found.neighbours, std::back_inserter(record.neighbours));
    if (seed != first_seed) continue;
    found.neighbours = std::move(record.neighbours);
    record = std::move(found);
  }
  const ExerciseReference exercise = described(first_seed);
  record.fingerprint = fingerprint_of(subject_of(exercise), record);
  return record;
}

LectureReference Lecture::evaluate(std::string name, std::uint64_t seed,
                                   const std::map<std::string, Adequacy>& recorded) const {
  LectureReference result{seed, std::move(name), {}};
  std::vector<Subject> all;
  for (const auto& each : exercises_) all.push_back(each->subject());
  for (const auto& each : exercises_) {
    const auto record = recorded.find(each->name());
    result.exercises.push_back(each->evaluate(seed, record == recorded.end() ? Adequacy() : record->second, all));
  }
  return result;
}

LectureReference Lecture::random_cases(std::string name, std::uint64_t seed) const {
  LectureReference result{seed, std::move(name), {}};
  for (const auto& each : exercises_) result.exercises.push_back(each->random_cases(seed));
  return result;
}

Adequacy Lecture::prove(const std::string& exercise, std::uint64_t seeds,
                        const std::map<std::string, Adequacy>& recorded) const {
  const auto named = std::ranges::find(exercises_, exercise, [](const auto& each) { return each->name(); });
  if (named == exercises_.end()) throw std::logic_error("there is no exercise " + exercise);
  const auto record = recorded.find(exercise);
  return (*named)->prove(seeds, record == recorded.end() ? Adequacy() : record->second);
}

}  // namespace workbook::judging
