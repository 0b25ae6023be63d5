#pragma once

#include "mlab/console/server/access.h"
#include "mlab/console/server/http.h"
#include "mlab/console/server/server.h"
#include "mlab/console/server/web_files.h"

namespace mlab::console {

/// What is asked under which address:
///
///     GET  /               the page                                   token
///     GET  /assets/...     what it loads
///     GET  /session        the WebSocket                              token
///     GET  /picture/N      the background picture of revision N       token
///     GET  /tiles/Z/C/R    a square of the map of the Earth           token
///     GET  /report         what happened so far, JSON                 token
///     GET  /metrics        what a monitoring system is told           token
///     POST /stop           emergency stop                             token
///     GET  /health         whether the server answers                 token
class Routes {
 public:
  Routes(Access access, WebFiles files) : access_(std::move(access)), files_(std::move(files)) {}

  /// The answer, with its security headers; any number of threads may ask. `/stop` stops.
  HttpResponse answer(const HttpRequest& request, const ServerHandlers& handlers) const;
  /// What is asked may have to wait for others, so it must not be answered on the network thread.
  static bool may_wait(const HttpRequest& request);

  const Access& access() const { return access_; }

 private:
  HttpResponse choose(const HttpRequest& request, const ServerHandlers& handlers) const;
  /// A page that opens with the token only.
  HttpResponse page(const HttpRequest& request, std::string_view name) const;
  HttpResponse file(const HttpRequest& request, const WebFiles::File& file) const;

  Access access_;
  WebFiles files_;
};

/// A short text, as the answer to what can't be done.
HttpResponse refusal(unsigned status, std::string text);

}  // namespace mlab::console
