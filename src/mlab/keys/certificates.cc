#include "mlab/keys/certificates.h"

#include <openssl/bio.h>
#include <openssl/ec.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/pkcs7.h>
#include <openssl/rand.h>
#include <openssl/x509.h>
#include <openssl/x509v3.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <memory>
#include <string_view>

#include <fmt/format.h>

#include "mlab/text/shown.h"

namespace mlab::keys {
namespace {

constexpr std::int64_t kDay = 86'400;  // [s]

template <auto kFree>
struct Free {
  template <class Value>
  void operator()(Value* value) const {
    kFree(value);
  }
};
using Bio = std::unique_ptr<BIO, Free<BIO_free_all>>;
using Key = std::unique_ptr<EVP_PKEY, Free<EVP_PKEY_free>>;
using Certificate = std::unique_ptr<X509, Free<X509_free>>;
using List = std::unique_ptr<X509_CRL, Free<X509_CRL_free>>;
using Document = std::unique_ptr<PKCS7, Free<PKCS7_free>>;
using Store = std::unique_ptr<X509_STORE, Free<X509_STORE_free>>;
using Context = std::unique_ptr<X509_STORE_CTX, Free<X509_STORE_CTX_free>>;

/// What libcrypto has to say of what failed last; it is forgotten then.
std::unexpected<std::string> failed(std::string_view what) {
  std::array<char, 256> words{};
  ERR_error_string_n(ERR_get_error(), words.data(), words.size());
  ERR_clear_error();
  return std::unexpected(fmt::format("{}: {}", what, text::shown(words.data())));
}

Bio reading(const std::string& text) {
  return Bio(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
}

std::string text_in(BIO* memory) {
  char* bytes = nullptr;
  const long size = BIO_get_mem_data(memory, &bytes);
  return {bytes, static_cast<std::size_t>(size)};
}

Certificate certificate_in(const std::string& text) {
  Certificate out(PEM_read_bio_X509(reading(text).get(), nullptr, nullptr, nullptr));
  ERR_clear_error();
  return out;
}

/// A key with a passphrase is none: nobody could be asked.
Key key_in(const std::string& text) {
  std::string none;
  Key out(PEM_read_bio_PrivateKey(reading(text).get(), nullptr, nullptr, none.data()));
  ERR_clear_error();
  return out;
}

List list_in(const std::string& text) {
  List out(PEM_read_bio_X509_CRL(reading(text).get(), nullptr, nullptr, nullptr));
  ERR_clear_error();
  return out;
}

/// Of any type of libcrypto's, by its own writer; empty where that fails.
template <class Write, class... Values>
std::string written(Write write, Values... values) {
  const Bio memory(BIO_new(BIO_s_mem()));
  return write(memory.get(), values...) == 1 ? text_in(memory.get()) : std::string();
}

std::string pem_of(EVP_PKEY* key) {
  return written(PEM_write_bio_PKCS8PrivateKey, key, nullptr, nullptr, 0, nullptr, nullptr);
}

std::int64_t seconds_of(const ASN1_TIME* time) {
  std::tm parts{};
  return ASN1_TIME_to_tm(time, &parts) == 1 ? ::timegm(&parts) : 0;
}

bool set_number(X509* certificate) {
  std::array<unsigned char, 16> bytes{};
  if (RAND_bytes(bytes.data(), bytes.size()) != 1) return false;
  bytes[0] = static_cast<unsigned char>((bytes[0] & 0x3fU) | 0x40U);  // positive, and of one length
  const std::unique_ptr<BIGNUM, Free<BN_free>> number(BN_bin2bn(bytes.data(), bytes.size(), nullptr));
  return number && BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(certificate)) != nullptr;
}

bool add_to_name(X509* certificate, int what, std::string_view words) {
  return X509_NAME_add_entry_by_NID(X509_get_subject_name(certificate), what, MBSTRING_UTF8,
                                    reinterpret_cast<const unsigned char*>(words.data()),
                                    static_cast<int>(words.size()), -1, 0) == 1;
}

bool set_name(X509* certificate, std::string_view name) {
  const std::size_t at = std::min(name.find('@'), name.size() - 1);
  return add_to_name(certificate, NID_organizationName, name.substr(at + 1)) &&
         add_to_name(certificate, NID_commonName, name.substr(0, at));
}

std::string part_of_name(const X509* certificate, int what) {
  std::array<char, 256> part{};
  const int size =
      X509_NAME_get_text_by_NID(X509_get_subject_name(certificate), what, part.data(), part.size());
  return size > 0 ? std::string(part.data(), static_cast<std::size_t>(size)) : std::string();
}

bool extend(X509* certificate, X509* issuer, int what, const char* value) {
  X509V3_CTX context;
  X509V3_set_ctx_nodb(&context);
  X509V3_set_ctx(&context, issuer, certificate, nullptr, nullptr, 0);
  const std::unique_ptr<X509_EXTENSION, Free<X509_EXTENSION_free>> extension(
      X509V3_EXT_conf_nid(nullptr, &context, what, value));
  return extension && X509_add_ext(certificate, extension.get(), -1) == 1;
}

bool set_validity(X509* certificate, const Validity& validity) {
  return ASN1_TIME_set(X509_getm_notBefore(certificate), validity.begin) != nullptr &&
         ASN1_TIME_set(X509_getm_notAfter(certificate), validity.end) != nullptr;
}

/// All but who issued it, and the signature.
bool begin_certificate(X509* certificate, EVP_PKEY* key, const std::string& name, const Validity& validity) {
  return X509_set_version(certificate, 2) == 1 && set_number(certificate) && set_name(certificate, name) &&
         set_validity(certificate, validity) && X509_set_pubkey(certificate, key) == 1;
}

bool finish_authority(X509* made, EVP_PKEY* key) {
  return X509_set_issuer_name(made, X509_get_subject_name(made)) == 1 &&
         extend(made, made, NID_basic_constraints, "critical,CA:TRUE,pathlen:0") &&
         extend(made, made, NID_key_usage, "critical,keyCertSign,cRLSign,digitalSignature") &&
         extend(made, made, NID_subject_key_identifier, "hash") && X509_sign(made, key, EVP_sha256()) > 0;
}

bool finish_identity(X509* made, X509* issuer, EVP_PKEY* key) {
  return X509_set_issuer_name(made, X509_get_subject_name(issuer)) == 1 &&
         extend(made, issuer, NID_basic_constraints, "critical,CA:FALSE") &&
         extend(made, issuer, NID_key_usage, "critical,digitalSignature,keyAgreement") &&
         extend(made, issuer, NID_authority_key_identifier, "keyid") &&
         X509_sign(made, key, EVP_sha256()) > 0;
}

std::string counts_later(std::int64_t begin) {
  return fmt::format("counts only {} from now: is this machine's clock right?",
                     days_between(seconds_now(), begin));
}

bool add_to(X509_CRL* list, X509* certificate, std::int64_t when) {
  std::unique_ptr<X509_REVOKED, Free<X509_REVOKED_free>> entry(X509_REVOKED_new());
  const std::unique_ptr<ASN1_TIME, Free<ASN1_TIME_free>> time(ASN1_TIME_set(nullptr, when));
  if (!entry || !time || X509_REVOKED_set_revocationDate(entry.get(), time.get()) != 1 ||
      X509_REVOKED_set_serialNumber(entry.get(), X509_get_serialNumber(certificate)) != 1 ||
      X509_CRL_add0_revoked(list, entry.get()) != 1)
    return false;
  [[maybe_unused]] X509_REVOKED* const given = entry.release();  // the list's now
  return true;
}

bool begin_list(X509_CRL* list, X509* issuer, const Validity& validity) {
  const std::unique_ptr<ASN1_TIME, Free<ASN1_TIME_free>> begin(ASN1_TIME_set(nullptr, validity.begin));
  const std::unique_ptr<ASN1_TIME, Free<ASN1_TIME_free>> end(ASN1_TIME_set(nullptr, validity.end));
  return begin && end && X509_CRL_set_version(list, 1) == 1 &&
         X509_CRL_set_issuer_name(list, X509_get_subject_name(issuer)) == 1 &&
         X509_CRL_set1_lastUpdate(list, begin.get()) == 1 && X509_CRL_set1_nextUpdate(list, end.get()) == 1;
}

}  // namespace

std::int64_t seconds_now() {
  return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

std::string days_between(std::int64_t earlier, std::int64_t later) {
  const std::int64_t days = (later - earlier) / kDay;
  return days == 0 ? "less than a day" : fmt::format("{} day{}", days, days == 1 ? "" : "s");
}

Validity valid_for_days(int days) {
  return {.begin = seconds_now() - kDay, .end = seconds_now() + days * kDay};
}

std::expected<KeyPair, std::string> make_authority(const std::string& name, const Validity& validity) {
  const Key key(EVP_EC_gen("P-256"));
  const Certificate made(X509_new());
  if (!key || !made || !begin_certificate(made.get(), key.get(), name, validity) ||
      !finish_authority(made.get(), key.get()))
    return failed("no certificate of an authority could be made");
  return KeyPair{.certificate = written(PEM_write_bio_X509, made.get()), .key = pem_of(key.get())};
}

std::expected<KeyPair, std::string> make_identity(const KeyPair& authority, const std::string& name,
                                                  const Validity& validity) {
  const Certificate issuer = certificate_in(authority.certificate);
  const Key issuing = key_in(authority.key);
  const Key key(EVP_EC_gen("P-256"));
  const Certificate made(X509_new());
  if (!issuer || !issuing || !key || !made || !begin_certificate(made.get(), key.get(), name, validity) ||
      !finish_identity(made.get(), issuer.get(), issuing.get()))
    return failed("no certificate could be made");
  return KeyPair{.certificate = written(PEM_write_bio_X509, made.get()), .key = pem_of(key.get())};
}

std::expected<std::string, std::string> sign_document(const KeyPair& authority, const std::string& text) {
  const Certificate issuer = certificate_in(authority.certificate);
  const Key issuing = key_in(authority.key);
  const int how = PKCS7_TEXT | PKCS7_DETACHED | PKCS7_STREAM;
  const Bio content = reading(text);
  if (!issuer || !issuing) return failed("the authority's key can't be used");
  const Document made(PKCS7_sign(issuer.get(), issuing.get(), nullptr, content.get(), how));
  const Bio memory(BIO_new(BIO_s_mem()));
  if (!made || SMIME_write_PKCS7(memory.get(), made.get(), content.get(), how) != 1)
    return failed("a document could not be signed");
  return text_in(memory.get());
}

std::expected<std::string, std::string> make_withdrawal_list(const KeyPair& authority,
                                                             const std::vector<std::string>& withdrawn,
                                                             const Validity& validity) {
  const Certificate issuer = certificate_in(authority.certificate);
  const Key issuing = key_in(authority.key);
  const List list(X509_CRL_new());
  if (!issuer || !issuing || !list || !begin_list(list.get(), issuer.get(), validity))
    return failed("no list of withdrawn certificates could be made");
  for (const std::string& one : withdrawn) {
    const Certificate certificate = certificate_in(one);
    if (!certificate || !add_to(list.get(), certificate.get(), seconds_now()))
      return failed("a certificate could not be withdrawn");
  }
  if (X509_CRL_sort(list.get()) != 1 || X509_CRL_sign(list.get(), issuing.get(), EVP_sha256()) <= 0)
    return failed("the list of withdrawn certificates could not be signed");
  return written(PEM_write_bio_X509_CRL, list.get());
}

std::string name_in(const std::string& certificate) {
  const Certificate read = certificate_in(certificate);
  if (!read) return {};
  return part_of_name(read.get(), NID_commonName) + "@" + part_of_name(read.get(), NID_organizationName);
}

std::string subject_in(const std::string& certificate) {
  const Certificate read = certificate_in(certificate);
  const Bio memory(BIO_new(BIO_s_mem()));
  if (!read) return {};
  X509_NAME_print_ex(memory.get(), X509_get_subject_name(read.get()), 0, XN_FLAG_RFC2253);
  return text_in(memory.get());
}

Validity validity_of(const std::string& certificate) {
  const Certificate read = certificate_in(certificate);
  if (!read) return {};
  return {.begin = seconds_of(X509_get0_notBefore(read.get())),
          .end = seconds_of(X509_get0_notAfter(read.get()))};
}

Validity list_validity_of(const std::string& list) {
  const List read = list_in(list);
  if (!read) return {};
  return {.begin = seconds_of(X509_CRL_get0_lastUpdate(read.get())),
          .end = seconds_of(X509_CRL_get0_nextUpdate(read.get()))};
}

std::expected<void, std::string> check_certificate(const std::string& certificate,
                                                   const std::string& authority) {
  const Certificate read = certificate_in(certificate);
  const Certificate issuer = certificate_in(authority);
  if (!read || !issuer) return std::unexpected("is no certificate (PEM)");
  const Key key(X509_get_pubkey(issuer.get()));
  if (X509_verify(read.get(), key.get()) != 1) {
    ERR_clear_error();
    return std::unexpected("was made by another authority");
  }
  const Validity validity = validity_of(certificate);
  if (seconds_now() >= validity.end)
    return std::unexpected(fmt::format("expired {} ago", days_between(validity.end, seconds_now())));
  if (seconds_now() < validity.begin) return std::unexpected(counts_later(validity.begin));
  return {};
}

std::expected<void, std::string> check_key(const std::string& certificate, const std::string& key) {
  const Certificate read = certificate_in(certificate);
  const Key secret = key_in(key);
  if (!secret) return std::unexpected("is no private key (PEM, without a passphrase)");
  const bool fits = read && X509_check_private_key(read.get(), secret.get()) == 1;
  ERR_clear_error();
  if (!fits) return std::unexpected("is not the key of the certificate");
  return {};
}

std::expected<std::string, std::string> check_document(const std::string& document,
                                                       const std::string& authority) {
  const Certificate issuer = certificate_in(authority);
  BIO* signed_bytes = nullptr;
  const Document read(SMIME_read_PKCS7(reading(document).get(), &signed_bytes));
  const Bio content(signed_bytes);
  ERR_clear_error();
  if (!read || !content) return std::unexpected("is no signed document (S/MIME)");
  const Store store(X509_STORE_new());
  const Bio text(BIO_new(BIO_s_mem()));
  X509_STORE_add_cert(store.get(), issuer.get());
  // Nobody else's certificate counts, whatever stands in the document.
  const std::unique_ptr<STACK_OF(X509), void (*)(STACK_OF(X509)*)> only(
      sk_X509_new_null(), [](STACK_OF(X509) * stack) { sk_X509_free(stack); });
  sk_X509_push(only.get(), issuer.get());
  const int how = PKCS7_TEXT | PKCS7_NOVERIFY | PKCS7_NOINTERN;
  const bool is_good = PKCS7_verify(read.get(), only.get(), store.get(), content.get(), text.get(), how) == 1;
  ERR_clear_error();
  if (!is_good) return std::unexpected("was not signed by this authority, or was changed since");
  return text_in(text.get());
}

std::expected<void, std::string> check_list(const std::string& list, const std::string& authority) {
  const List read = list_in(list);
  const Certificate issuer = certificate_in(authority);
  if (!read) return std::unexpected("is no list of withdrawn certificates (PEM)");
  const Key key(issuer ? X509_get_pubkey(issuer.get()) : nullptr);
  const bool is_good = key && X509_CRL_verify(read.get(), key.get()) == 1;
  ERR_clear_error();
  if (!is_good) return std::unexpected("was not signed by this authority, or was changed since");
  const Validity validity = list_validity_of(list);
  if (seconds_now() < validity.begin) return std::unexpected(counts_later(validity.begin));
  if (validity.end > seconds_now()) return {};
  return std::unexpected("is out of date");
}

std::expected<bool, std::string> is_withdrawn(const std::string& list, const std::string& certificate,
                                              const std::string& authority) {
  if (const auto good = check_list(list, authority); !good) return std::unexpected(good.error());
  const Certificate one = certificate_in(certificate);
  if (!one) return std::unexpected("can't be held against what is no certificate");
  X509_REVOKED* found = nullptr;
  return X509_CRL_get0_by_cert(list_in(list).get(), &found, one.get()) == 1;
}

}  // namespace mlab::keys
