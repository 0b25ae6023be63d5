#include "mlab/console/server/routes.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>

#include <fmt/core.h>

namespace mlab::console {
namespace {

using Method = HttpRequest::Method;

constexpr std::string_view kPicture = "/picture/";
constexpr std::string_view kTiles = "/tiles/";

HttpResponse say(std::string content_type, std::string text) {
  HttpResponse out;
  out.content_type = std::move(content_type);
  out.body = std::make_shared<const std::string>(std::move(text));
  out.fields.emplace_back("Cache-Control", "no-store");
  return out;
}

std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool is_private(std::string_view path) {
  return path == "/session" || path == "/designer" || path == "/report" || path == "/stop" ||
         path == "/health" || path == "/metrics" || path.starts_with(kPicture) || path.starts_with(kTiles);
}

HttpResponse wrong_method(std::string allowed) {
  HttpResponse out = refusal(405, "this address takes " + allowed);
  out.fields.emplace_back("Allow", std::move(allowed));
  return out;
}

// The token in its address is another one after the next start.
HttpResponse kept_picture(Content content) {
  HttpResponse out;
  out.content_type = std::move(content.type);
  out.body = std::move(content.bytes);
  out.fields.emplace_back("Cache-Control", "private, max-age=86400");
  return out;
}

HttpResponse picture(const ServerHandlers& handlers, std::string_view revision) {
  const std::optional<std::uint64_t> wanted = number(revision);
  Content content = wanted ? handlers.picture(*wanted) : Content{};
  if (!content.bytes) return refusal(404, "there is no picture of this revision");
  return kept_picture(std::move(content));
}

// Zoom, column and row, and nothing else.
HttpResponse tile(const ServerHandlers& handlers, std::string_view square) {
  std::array<std::uint64_t, 3> at{};
  bool is_square = true;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const std::size_t end = i + 1 < at.size() ? square.find('/') : square.size();
    const std::optional<std::uint64_t> one = number(square.substr(0, end));
    is_square = is_square && end != std::string_view::npos && one && *one <= UINT32_MAX;
    if (!is_square) break;
    at[i] = *one;
    square.remove_prefix(std::min(end + 1, square.size()));
  }
  Content content = is_square && handlers.tile
                        ? handlers.tile(static_cast<std::uint32_t>(at[0]), static_cast<std::uint32_t>(at[1]),
                                        static_cast<std::uint32_t>(at[2]))
                        : Content{};
  if (!content.bytes) return refusal(404, "there is no such tile");
  return kept_picture(std::move(content));
}

HttpResponse metrics_of(const ServerHandlers& handlers) {
  metrics::Exposition out;
  handlers.metrics(out);
  return say(std::string(metrics::Exposition::kContentType), out.text());
}

}  // namespace

std::string_view HttpRequest::parameter(std::string_view name) const {
  std::string_view rest = target.substr(std::min(target.find('?'), target.size()));
  while (!rest.empty()) {
    rest.remove_prefix(1);  // ? or &
    const std::string_view pair = rest.substr(0, rest.find('&'));
    if (pair.starts_with(name) && pair.substr(name.size()).starts_with('='))
      return pair.substr(name.size() + 1);
    rest.remove_prefix(pair.size());
  }
  return {};
}

HttpResponse refusal(unsigned status, std::string text) {
  HttpResponse out = say("text/plain; charset=utf-8", std::move(text) + "\n");
  out.status = status;
  return out;
}

bool Routes::may_wait(const HttpRequest& request) {
  return request.path() == "/report" || request.path().starts_with(kPicture) ||
         request.path().starts_with(kTiles);
}

HttpResponse Routes::answer(const HttpRequest& request, const ServerHandlers& handlers) const {
  HttpResponse out = choose(request, handlers);
  // Everything comes from here, nothing is framed or guessed, and no address (it holds the token) is passed
  // on. Styles are set by script: the editor makes its own.
  out.fields.emplace_back(
      "Content-Security-Policy",
      fmt::format("default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' "
                  "data: blob:; "
                  "font-src 'self'; worker-src 'self' blob:; manifest-src 'self'; connect-src 'self'{}; "
                  "base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
                  access_.is_for_us(request.host) ? " " + access_.socket_origin(request.host) : ""));
  out.fields.emplace_back("X-Content-Type-Options", "nosniff");
  out.fields.emplace_back("Referrer-Policy", "no-referrer");
  out.fields.emplace_back("Cross-Origin-Opener-Policy", "same-origin");
  out.fields.emplace_back("Cross-Origin-Resource-Policy", "same-origin");
  return out;
}

HttpResponse Routes::choose(const HttpRequest& request, const ServerHandlers& handlers) const {
  if (!access_.is_for_us(request.host))
    return refusal(421, "this server does not go by that name; use the address that mlab printed");
  const std::string_view path = request.path();
  const bool reads = request.method == Method::kGet || request.method == Method::kHead;
  if (is_private(path)) {
    if (!access_.is_from_us(request)) return refusal(403, "pages of other sites get nothing here");
    if (!access_.has_token(request)) return refusal(403, "the token is missing or wrong");
    if (path == "/stop") {
      if (request.method != Method::kPost) return wrong_method("POST");
      handlers.emergency_stop();
      return say("application/json", "{\"stopped\": true}\n");
    }
    if (!reads) return wrong_method("GET, HEAD");
    if (path == "/report") return say("application/json", handlers.report());
    if (path == "/health") return say("application/json", "{\"ok\": true}\n");
    if (path == "/metrics") return metrics_of(handlers);
    if (path.starts_with(kTiles)) return tile(handlers, path.substr(kTiles.size()));
    if (path.starts_with(kPicture)) return picture(handlers, path.substr(kPicture.size()));
    if (path == "/designer" && !handlers.designer.receive)
      return refusal(404, "the designer is not open here; start it with `mlab edit`");
    HttpResponse out = refusal(426, "this address is a WebSocket");
    if (request.is_upgrade && request.method == Method::kGet)
      out.status = 101;
    else
      out.fields.emplace_back("Upgrade", "websocket");
    return out;
  }
  if (!reads) return wrong_method("GET, HEAD");
  if (path == "/" || path == "/index.html") return page(request, "/index.html");
  if (path == "/designer.html") return page(request, "/designer.html");
  if (const WebFiles::File* found = files_.find(path)) return file(request, *found);
  return refusal(404, "there is nothing here");
}

HttpResponse Routes::page(const HttpRequest& request, std::string_view name) const {
  if (!access_.has_token(request)) {
    return refusal(
        403,
        "This is a page of mlab. It opens with the whole address that `mlab run` or `mlab edit` printed, "
        "`?token=...` included;\na new start of mlab has a new one.");
  }
  const WebFiles::File* index = files_.find(name);
  if (index == nullptr) return refusal(503, "the web files of this page are not installed with this mlab");
  HttpResponse out;
  out.content_type = index->content_type;
  out.body = index->bytes;
  out.fields.emplace_back("Cache-Control", "no-store");
  return out;
}

HttpResponse Routes::file(const HttpRequest& request, const WebFiles::File& file) const {
  HttpResponse out;
  out.content_type = file.content_type;
  out.fields.emplace_back("ETag", file.etag);
  out.fields.emplace_back("Cache-Control",
                          file.is_immutable ? "public, max-age=31536000, immutable" : "no-cache");
  if (request.if_none_match.find(file.etag) == std::string_view::npos)
    out.body = file.bytes;
  else
    out.status = 304;
  return out;
}

}  // namespace mlab::console
