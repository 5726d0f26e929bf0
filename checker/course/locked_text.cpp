#include "checker/course/locked_text.hpp"

#include "checker/base/text.hpp"
#include "checker/judging/comparison.hpp"

#include <sodium.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <random>

namespace workbook {

namespace {

using nlohmann::json;

constexpr int locked_format = 1;
constexpr double enough_bits = 48;  // beside the slow hash below

/// One input at which the key was made.
struct LockedCall {
  std::vector<Value> inputs;
  int rows = 0, cols = 0;
  std::vector<double> quanta;  ///< 0: not used, so near to where rounding changes that a right answer could differ
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LockedCall, inputs, rows, cols, quanta)

/// One number of a result, with the freedom of its comparison taken out.
double canonical(double number, Comparison comparison) {
  switch (comparison) {
    case Comparison::up_to_sign:
    case Comparison::eigenvectors:
      return std::abs(number);
    case Comparison::attitude_by_angles:
    case Comparison::attitude_by_yaw_pitch_roll:
      return std::cos(number);
    case Comparison::plain:
    case Comparison::rotation_by_vector:
      break;
  }
  return number;
}

unsigned char* raw(std::string& bytes) { return reinterpret_cast<unsigned char*>(bytes.data()); }
const unsigned char* raw(const std::string& bytes) { return reinterpret_cast<const unsigned char*>(bytes.data()); }

/// A key from results as whole numbers of their quanta.
std::string key_of(const std::string& secret, const std::string& salt) {
  std::string key(crypto_secretbox_KEYBYTES, '\0');
  if (crypto_pwhash(raw(key), key.size(), secret.data(), secret.size(), raw(salt), crypto_pwhash_OPSLIMIT_INTERACTIVE,
                    crypto_pwhash_MEMLIMIT_INTERACTIVE, crypto_pwhash_ALG_DEFAULT) != 0)
    throw std::runtime_error("There is too little memory to make a key from your results (64 MiB).");
  return key;
}

std::string whole_numbers(const Value& value, Comparison comparison, const std::vector<double>& quanta) {
  std::string text;
  for (std::size_t i = 0; i < quanta.size(); ++i)
    if (quanta[i] > 0)
      text += fmt::format("{:.0f} ", std::round(canonical(value.numbers.at(i), comparison) / quanta[i]) + 0.0);
  return text;
}

struct ResultsForKey {
  std::vector<LockedCall> calls;
  std::string secret;
  double bits = 0;  ///< to be guessed by somebody who knows which results are frequent
};

/// In random order: that of the cases tells whole numbers.
ResultsForKey results_for_key(const ExerciseReference& reference) {
  std::vector<Case> cases;
  std::ranges::copy_if(reference.cases, std::back_inserter(cases),
                       [](auto& one) { return one.group == Group::random; });
  std::ranges::shuffle(cases, std::random_device());
  const bool is_whole = reference.result_kind == Kind::integer;
  std::map<double, double> shares;
  for (const Case& one : cases)
    if (is_whole) shares[one.expected.numbers.at(0)] += 1.0 / static_cast<double>(cases.size());
  double largest_share = 0;
  for (const auto& [number, share] : shares) largest_share = std::max(largest_share, share);
  ResultsForKey made;
  for (const Case& one : cases) {
    if (made.bits >= 2 * enough_bits) break;
    std::vector<double> quanta;
    for (std::size_t i = 0; i < one.expected.numbers.size(); ++i) {
      const double quantum = is_whole ? 1.0 : std::max(100 * one.tolerance, 1e-6) * scale_at(one, i);
      const double quotient = canonical(one.expected.numbers[i], reference.comparison) / quantum;
      const bool is_clear = std::abs(quotient - std::round(quotient)) < 0.4;
      quanta.push_back(is_clear ? quantum : 0.0);
      if (is_clear)
        made.bits +=
            is_whole ? -std::log2(largest_share) : std::log2(1 + std::abs(quotient));
    }
    made.calls.push_back({one.inputs, one.expected.rows, one.expected.cols, quanta});
    made.secret += whole_numbers(one.expected, reference.comparison, quanta);
  }
  return made;
}

std::string random_bytes(std::size_t count) {
  std::string bytes(count, '\0');
  randombytes_buf(bytes.data(), bytes.size());
  return bytes;
}

void start_sodium() {
  if (sodium_init() < 0) throw std::runtime_error("libsodium cannot be started on this machine.");
}

struct LockedText {
  Comparison comparison{};
  std::vector<LockedCall> calls;
  std::string box, nonce, salt;
};

LockedText read_locked(const std::string& locked) {
  try {
    const json document = json::parse(locked);
    if (document.at("format") != locked_format) throw std::runtime_error("another format");
    const auto bytes = [&](const char* part) { return from_base64(document.at(part).get<std::string>()); };
    LockedText read{static_cast<Comparison>(document.at("comparison").get<int>()),
                    document.at("calls").get<std::vector<LockedCall>>(), bytes("box"), bytes("nonce"), bytes("salt")};
    if (read.box.size() < crypto_secretbox_MACBYTES || read.nonce.size() != crypto_secretbox_NONCEBYTES ||
        read.salt.size() != crypto_pwhash_SALTBYTES)
      throw std::runtime_error("wrong sizes");
    return read;
  } catch (const std::exception& problem) {
    throw std::runtime_error(fmt::format("The locked text is damaged ({}).", problem.what()));
  }
}

}  // namespace

bool makes_key(const ExerciseReference& reference) { return results_for_key(reference).bits >= enough_bits; }

std::string locked_text(const ExerciseReference& reference, const std::string& text) {
  start_sodium();
  const auto [calls, secret, bits] = results_for_key(reference);
  if (bits < enough_bits) throw std::runtime_error(fmt::format("{} has too few cases for a key", reference.name));
  const std::string salt = random_bytes(crypto_pwhash_SALTBYTES), nonce = random_bytes(crypto_secretbox_NONCEBYTES);
  std::string box(text.size() + crypto_secretbox_MACBYTES, '\0');
  crypto_secretbox_easy(raw(box), raw(text), text.size(), raw(nonce), raw(key_of(secret, salt)));
  const json document = {{"format", locked_format}, {"comparison", static_cast<int>(reference.comparison)},
                         {"calls", calls},          {"salt", base64(salt)},
                         {"nonce", base64(nonce)},  {"box", base64(box)}};
  return document.dump() + "\n";
}

std::vector<PlannedCall> calls_of_locked(const std::string& locked) {
  std::vector<PlannedCall> calls;
  for (const LockedCall& call : read_locked(locked).calls) calls.push_back({call.inputs, call.rows, call.cols});
  return calls;
}

std::optional<std::string> unlocked_text(const std::string& locked, const std::vector<Reply>& replies) {
  start_sodium();
  const auto [comparison, calls, box, nonce, salt] = read_locked(locked);
  std::string secret;
  for (std::size_t k = 0; k < calls.size(); ++k) {
    if (k >= replies.size() || replies[k].ending != Ending::returned ||
        replies[k].value.numbers.size() < calls[k].quanta.size())
      return std::nullopt;
    secret += whole_numbers(replies[k].value, comparison, calls[k].quanta);
  }
  std::string text(box.size() - crypto_secretbox_MACBYTES, ' ');
  if (crypto_secretbox_open_easy(raw(text), raw(box), box.size(), raw(nonce), raw(key_of(secret, salt))) != 0)
    return std::nullopt;
  return text;
}

}  // namespace workbook
