#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mlab::console {

/// What of an HTTP request matters here. Views into the request; empty where it says nothing.
struct HttpRequest {
  enum class Method { kGet, kHead, kPost, kOther };
  Method method = Method::kGet;
  std::string_view target;  ///< `/path?query`
  std::string_view host;
  std::string_view origin;
  std::string_view authorization;
  std::string_view if_none_match;
  std::string_view fetch_site;  ///< Sec-Fetch-Site: where the page that asks came from
  bool is_upgrade = false;      ///< to a WebSocket

  std::string_view path() const { return target.substr(0, target.find('?')); }
  /// Of the query, as it was sent; empty where it is missing.
  std::string_view parameter(std::string_view name) const;
};

/// What an HTTP request is answered.
struct HttpResponse {
  unsigned status = 200;  ///< 101: the connection becomes a session's
  std::string content_type = "text/plain; charset=utf-8";
  std::shared_ptr<const std::string> body;
  std::vector<std::pair<std::string, std::string>> fields;
};

}  // namespace mlab::console
