#include "mlab/designer/session/safekeeping.h"

#include "mlab/designer/session/request.h"

namespace mlab::designer {

void Safekeeping::keep() {
  desk_.store().keep_drafts(wall_time());
  marks_.keep_again();
  tell();
}

void Safekeeping::sync() {
  desk_.store().sync_drafts(wall_time());
  tell();
}

void Safekeeping::tell() {
  std::string why = desk_.not_kept();
  if (why.empty() && !marks_.losses().empty()) why = marks_.losses().front();
  if (why == not_kept_) return;
  not_kept_ = std::move(why);
  if (tell_not_kept_) tell_not_kept_(not_kept_);
}

}  // namespace mlab::designer
