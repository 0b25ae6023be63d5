#include "mlab/console/server/token.h"

#include <openssl/crypto.h>
#include <sys/random.h>

#include <array>
#include <system_error>

#include <fmt/core.h>

namespace mlab::console {

std::string make_token() {
  std::array<unsigned char, 20> bytes{};
  // Up to 256 bytes come whole or not at all.
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::system_error(errno, std::generic_category(), "no random numbers for the console's token");
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

bool is_same_token(std::string_view given, std::string_view token) {
  return given.size() == token.size() && CRYPTO_memcmp(given.data(), token.data(), token.size()) == 0;
}

}  // namespace mlab::console
