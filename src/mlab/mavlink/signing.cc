#include "mlab/mavlink/signing.h"

#include <openssl/crypto.h>
#include <openssl/evp.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>

namespace mlab::mavlink {
namespace {

// From 1970 to 2015 [s].
constexpr std::uint64_t kSecondsBefore = 1'420'070'400;
constexpr SigningTime kMinute = 6'000'000;
constexpr SigningTime kTimeBits = (SigningTime{1} << 48) - 1;

using Digest = std::array<std::byte, 32>;

Digest sha256(std::initializer_list<std::span<const std::byte>> pieces) {
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
  Digest out{};
  EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr);
  for (const auto& piece : pieces) EVP_DigestUpdate(context.get(), piece.data(), piece.size());
  EVP_DigestFinal_ex(context.get(), reinterpret_cast<unsigned char*>(out.data()), nullptr);
  return out;
}

int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

text::Result<Key> parse_key(std::string_view text) {
  constexpr std::string_view kPassphrase = "passphrase:";
  if (text.starts_with(kPassphrase) && text.size() > kPassphrase.size())
    return sha256({std::as_bytes(std::span(text.substr(kPassphrase.size())))});
  Key out{};
  bool is_key = text.size() == 2 * out.size();
  for (std::size_t i = 0; is_key && i < out.size(); ++i) {
    const int high = digit_of(text[2 * i]);
    const int low = digit_of(text[2 * i + 1]);
    is_key = high >= 0 && low >= 0;
    out[i] = static_cast<std::byte>(high * 16 + low);
  }
  if (is_key) return out;
  text::Diagnostic wrong;
  wrong.kind = "mavlink-key";
  wrong.message =
      "a key of " + std::to_string(text.size()) +
      " characters (not shown); expected 64 hexadecimal digits, or `passphrase:` and a passphrase";
  return std::unexpected(std::move(wrong));
}

SigningTime signing_time_now() {
  const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
  const auto us = std::chrono::duration_cast<std::chrono::microseconds>(since_1970).count();
  const auto begin = static_cast<std::int64_t>(kSecondsBefore * 1'000'000);
  return us > begin ? static_cast<SigningTime>(us - begin) / 10 : 0;
}

std::array<std::byte, Signature::kSize> Signature::bytes() const {
  std::array<std::byte, kSize> out{};
  out[0] = static_cast<std::byte>(link);
  for (std::size_t i = 0; i < 6; ++i) out[1 + i] = static_cast<std::byte>(time >> (8 * i));
  std::ranges::copy(digest, out.begin() + 7);
  return out;
}

Signature Signature::read(std::span<const std::byte> bytes) {
  Signature out;
  out.link = static_cast<std::uint8_t>(bytes[0]);
  for (std::size_t i = 0; i < 6; ++i) out.time |= static_cast<SigningTime>(bytes[1 + i]) << (8 * i);
  std::ranges::copy(bytes.subspan(7, 6), out.digest.begin());
  return out;
}

Signature sign(const Key& key, std::span<const std::byte> frame, std::uint8_t link, SigningTime time) {
  Signature out;
  out.link = link;
  out.time = time & kTimeBits;
  const auto head = out.bytes();
  const Digest digest = sha256({key, frame, std::span(head).first(7)});
  std::copy_n(digest.begin(), out.digest.size(), out.digest.begin());
  return out;
}

Signatures::Verdict Signatures::judge(std::span<const std::byte> frame, std::uint8_t system,
                                      std::uint8_t component, const Signature& signature, SigningTime now) {
  const Signature right = sign(key_, frame, signature.link, signature.time);
  if (CRYPTO_memcmp(right.digest.data(), signature.digest.data(), right.digest.size()) != 0)
    return Verdict::kWrong;
  const Sender sender{system, component, signature.link};
  const auto found = last_.find(sender);
  if (found != last_.end()) {
    if (signature.time <= found->second) return Verdict::kReplayed;
    found->second = signature.time;
  } else {
    if (signature.time + kMinute < std::max(now, latest_) || last_.size() >= kMostSenders)
      return Verdict::kReplayed;
    last_.emplace(sender, signature.time);
  }
  latest_ = std::max(latest_, signature.time);
  return Verdict::kGood;
}

SigningTime Signatures::next_time(SigningTime now) {
  latest_ = std::max(latest_ + 1, now) & kTimeBits;
  return latest_;
}

}  // namespace mlab::mavlink
