#pragma once

#include <cstdint>
#include <expected>
#include <string>
#include <vector>

// Keys, certificates, signatures and lists of certificates that were withdrawn: values in PEM, by libcrypto.
// Keys are of the curve P-256, the one that DDS Security names. Errors are sentences.
namespace mlab::keys {

/// A certificate with its private key. Secret.
struct KeyPair {
  std::string certificate;
  std::string key;
};

/// From a day ago on, so that machines whose clock is behind accept what was just made.
struct Validity {
  std::int64_t begin = 0;  ///< [s since 1970]
  std::int64_t end = 0;    ///< [s since 1970]
};
Validity valid_for_days(int days);

/// Names are `NAME@FLEET`, each of at most 64 letters: a certificate's common name and organization.
///
/// Signs itself, and others.
std::expected<KeyPair, std::string> make_authority(const std::string& name, const Validity& validity);

std::expected<KeyPair, std::string> make_identity(const KeyPair& authority, const std::string& name,
                                                  const Validity& validity);

/// What DDS Security calls a signed document: S/MIME, the text in the clear.
std::expected<std::string, std::string> sign_document(const KeyPair& authority, const std::string& text);

/// The list of certificates that are no longer good, signed.
/// @param withdrawn  certificates of this authority
std::expected<std::string, std::string> make_withdrawal_list(const KeyPair& authority,
                                                             const std::vector<std::string>& withdrawn,
                                                             const Validity& validity);

/// As it was given; empty: it is no certificate of ours.
std::string name_in(const std::string& certificate);

/// The name as permissions have to name it.
std::string subject_in(const std::string& certificate);

/// From when on, and till when it is good. All zero: it is no certificate.
Validity validity_of(const std::string& certificate);

/// The same of a list of withdrawn certificates.
Validity list_validity_of(const std::string& list);

/// In words: `3 days`, `less than a day`.
/// @param earlier, later  [s since 1970]
std::string days_between(std::int64_t earlier, std::int64_t later);

/// By the machine's clock [s since 1970].
std::int64_t seconds_now();

/// Why a certificate is not good now, whatever list there is.
/// @errors  half a sentence: `is no certificate`, `expired 3 days ago`
std::expected<void, std::string> check_certificate(const std::string& certificate,
                                                   const std::string& authority);

/// @errors  half a sentence
std::expected<void, std::string> check_key(const std::string& certificate, const std::string& key);

/// @return  the document's text
/// @errors  half a sentence: it is none, or somebody else has signed it
std::expected<std::string, std::string> check_document(const std::string& document,
                                                       const std::string& authority);

/// @errors  half a sentence: it is no list, or somebody else's, or out of date
std::expected<void, std::string> check_list(const std::string& list, const std::string& authority);

/// Whether the list holds the certificate.
/// @errors  as of `check_list`
std::expected<bool, std::string> is_withdrawn(const std::string& list, const std::string& certificate,
                                              const std::string& authority);

}  // namespace mlab::keys
