#include "mlab/documents/draft_keeper.h"

namespace mlab::documents {
namespace {

constexpr double kPause = 1.0;  // before what failed is tried again [s]

}  // namespace

void DraftKeeper::follow(const Text& text, DraftState& state, double now, When when) {
  const std::uint64_t wanted = text.is_unsaved ? text.revision : 0;
  if (state.kept == wanted && state.problem.empty()) return;
  const bool has_just_failed =
      !state.problem.empty() && state.tried == text.revision && now - state.time < kPause;
  if (has_just_failed && when == When::kNowAndThen) return;
  state.tried = text.revision;
  state.time = now;
  state.problem = !text.is_unsaved          ? drafts_.drop(text.path)
                  : text.older_file.empty() ? drafts_.keep(text.path, text.text, text.file)
                                            : drafts_.keep_of(text.older_file, text.path, text.text);
  if (!state.problem.empty()) return;
  state.kept = wanted;
  state.synced = 0;
}

void DraftKeeper::sync(std::string_view path, DraftState& state) const {
  if (state.kept == 0 || state.synced == state.kept || !state.problem.empty()) return;
  state.problem = drafts_.sync(path);
  if (state.problem.empty()) state.synced = state.kept;
}

void DraftKeeper::look(double now) {
  if (folder_problem_.empty() || now - looked_ < kPause) return;
  looked_ = now;
  folder_problem_ = drafts_.problem();
}

}  // namespace mlab::documents
