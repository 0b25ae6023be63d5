#include "mlab/console/server/access.h"

#include <arpa/inet.h>

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/server/token.h"

namespace mlab::console {
namespace {

bool is_address(const std::string& text) {
  in6_addr any{};
  return ::inet_pton(AF_INET, text.c_str(), &any) == 1 || ::inet_pton(AF_INET6, text.c_str(), &any) == 1;
}

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return out;
}

// `127.0.0.1:8642`, `[::1]:8642`, `machine`: the name, and the port or nothing.
std::pair<std::string, std::string_view> split(std::string_view host) {
  if (host.starts_with('[')) {
    const std::size_t end = std::min(host.find(']'), host.size() - 1);
    const std::string_view rest = host.substr(end + 1);
    return {lower(host.substr(1, end - 1)), rest.starts_with(':') ? rest.substr(1) : rest};
  }
  const std::size_t colon = host.rfind(':');
  if (colon == std::string_view::npos) return {lower(host), {}};
  return {lower(host.substr(0, colon)), host.substr(colon + 1)};
}

bool is_loopback_name(const std::string& name) {
  return name == "localhost" || name == "::1" || (name.starts_with("127.") && is_address(name));
}

}  // namespace

Access::Access(std::string token, Place place) : token_(std::move(token)), place_(std::move(place)) {
  place_.hostname = lower(place_.hostname);
}

bool Access::is_for_us(std::string_view host) const {
  const auto [name, port] = split(host);
  const std::string_view standard = place_.is_encrypted ? "443" : "80";
  if ((port.empty() ? standard : port) != std::to_string(place_.port)) return false;
  if (is_loopback_name(name)) return true;
  if (is_loopback_name(place_.address)) return false;
  // A stranger's domain has no certificate of ours.
  return place_.is_encrypted || is_address(name) ||
         (!name.empty() && (name == place_.hostname || name == place_.hostname + ".local"));
}

bool Access::is_from_us(const HttpRequest& request) const {
  if (!request.fetch_site.empty() && request.fetch_site != "same-origin" && request.fetch_site != "none")
    return false;
  if (request.origin.empty()) return true;
  return request.origin == fmt::format("{}://{}", place_.is_encrypted ? "https" : "http", request.host);
}

bool Access::has_token(const HttpRequest& request) const {
  constexpr std::string_view kBearer = "bearer ";  // in any letter case (RFC 9110, 11.1)
  if (lower(std::string_view(request.authorization).substr(0, kBearer.size())) == kBearer)
    return is_same_token(request.authorization.substr(kBearer.size()), token_);
  return is_same_token(request.parameter("token"), token_);
}

std::string Access::socket_origin(std::string_view host) const {
  return fmt::format("{}://{}", place_.is_encrypted ? "wss" : "ws", host);
}

}  // namespace mlab::console
