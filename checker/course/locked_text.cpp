#include "checker/course/locked_text.hpp"

#include "checker/judging/comparison.hpp"

#include <fmt/format.h>
#include <sodium.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace workbook {

namespace {

using nlohmann::json;
using Bytes = std::vector<unsigned char>;

constexpr int locked_format = 1;
constexpr double enough_bits = 48;  // beside the slow hash below

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

/// A key from results as whole numbers of their quanta.
Bytes key_of(const std::string& secret, const Bytes& salt) {
  Bytes key(crypto_secretbox_KEYBYTES);
  if (crypto_pwhash(key.data(), key.size(), secret.data(), secret.size(), salt.data(),
                    crypto_pwhash_OPSLIMIT_INTERACTIVE, crypto_pwhash_MEMLIMIT_INTERACTIVE,
                    crypto_pwhash_ALG_DEFAULT) != 0)
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

Bytes random_bytes(std::size_t count) {
  Bytes bytes(count);
  randombytes_buf(bytes.data(), bytes.size());
  return bytes;
}

void start_sodium() {
  if (sodium_init() < 0) throw std::runtime_error("libsodium cannot be started on this machine.");
}

}  // namespace

std::string locked_text(const ExerciseReference& reference, const std::string& text) {
  start_sodium();
  json calls = json::array();
  std::string secret;
  double bits = 0;
  for (const Case& one : reference.cases) {
    if (one.group != Group::random || bits >= 2 * enough_bits) continue;
    std::vector<double> quanta;  // 0: not used, so near to where rounding changes that a right answer could differ
    for (std::size_t i = 0; i < one.expected.numbers.size(); ++i) {
      const bool is_whole = reference.result_kind == Kind::integer;
      const double quantum = is_whole ? 1.0 : std::max(100 * one.tolerance, 1e-6) * scale_at(one, i);
      const double quotient = canonical(one.expected.numbers[i], reference.comparison) / quantum;
      const bool is_clear = std::abs(quotient - std::round(quotient)) < 0.4;
      quanta.push_back(is_clear ? quantum : 0.0);
      if (is_clear) bits += is_whole ? 1 : std::log2(1 + std::abs(quotient));
    }
    calls.push_back(
        {{"inputs", one.inputs}, {"rows", one.expected.rows}, {"cols", one.expected.cols}, {"quanta", quanta}});
    secret += whole_numbers(one.expected, reference.comparison, quanta);
  }
  if (bits < enough_bits && reference.result_kind != Kind::integer)
    throw std::runtime_error(fmt::format("{} has too few cases for a key", reference.name));
  const Bytes salt = random_bytes(crypto_pwhash_SALTBYTES), nonce = random_bytes(crypto_secretbox_NONCEBYTES);
  Bytes box(text.size() + crypto_secretbox_MACBYTES);
  crypto_secretbox_easy(box.data(), reinterpret_cast<const unsigned char*>(text.data()), text.size(), nonce.data(),
                        key_of(secret, salt).data());
  const json document = {{"format", locked_format}, {"comparison", static_cast<int>(reference.comparison)},
                         {"calls", calls},          {"salt", salt},
                         {"nonce", nonce},          {"box", box}};
  return document.dump() + "\n";
}

std::optional<std::string> unlocked_text(const std::string& locked, const Evaluate& evaluate) {
  start_sodium();
  try {
    const json document = json::parse(locked);
    if (document.at("format") != locked_format) throw std::runtime_error("another format");
    const auto comparison = static_cast<Comparison>(document.at("comparison").get<int>());
    std::string secret;
    for (const json& call : document.at("calls")) {
      const auto quanta = call.at("quanta").get<std::vector<double>>();
      const auto value = evaluate(call.at("inputs").get<std::vector<Value>>(), call.at("rows"), call.at("cols"));
      if (!value || value->numbers.size() < quanta.size()) return std::nullopt;
      secret += whole_numbers(*value, comparison, quanta);
    }
    const auto box = document.at("box").get<Bytes>(), nonce = document.at("nonce").get<Bytes>();
    const auto salt = document.at("salt").get<Bytes>();
    if (box.size() < crypto_secretbox_MACBYTES || nonce.size() != crypto_secretbox_NONCEBYTES ||
        salt.size() != crypto_pwhash_SALTBYTES)
      throw std::runtime_error("wrong sizes");
    std::string text(box.size() - crypto_secretbox_MACBYTES, ' ');
    if (crypto_secretbox_open_easy(reinterpret_cast<unsigned char*>(text.data()), box.data(), box.size(), nonce.data(),
                                   key_of(secret, salt).data()) != 0)
      return std::nullopt;
    return text;
  } catch (const json::exception& problem) {
    throw std::runtime_error(fmt::format("The locked text is damaged ({}).", problem.what()));
  }
}

}  // namespace workbook
