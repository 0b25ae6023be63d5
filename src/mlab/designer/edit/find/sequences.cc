#include "mlab/designer/edit/find/sequences.h"

#include <algorithm>

#include <fmt/core.h>

#include "mlab/designer/edit/find/pages.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/text/shown.h"

namespace mlab::designer {

const cdl::State* state_named(const cdl::Sequence& sequence, std::string_view name) {
  const auto found =
      std::ranges::find_if(sequence.states, [&](const cdl::State& state) { return state.name.text == name; });
  return found == sequence.states.end() ? nullptr : &*found;
}

text::Result<const cdl::Sequence*> find_sequence(const Model& model, const std::string& page) {
  const text::Result<PageView> view = find_page(model, page);
  if (!view) return std::unexpected(view.error());
  if (view->page->sequence == nullptr) return refusal("this page has no states");
  return view->page->sequence;
}

text::Result<const cdl::Transition*> find_transition(const Model& model, const std::string& page,
                                                     const std::string& from, std::uint32_t index) {
  const text::Result<const cdl::Sequence*> all = find_sequence(model, page);
  if (!all) return std::unexpected(all.error());
  const cdl::State* state = state_named(**all, from);
  if (state == nullptr) return refusal(fmt::format("there is no state `{}`", text::shown(from)));
  if (index >= state->transitions.size()) return refusal("the transition has gone");
  return &state->transitions[index];
}

}  // namespace mlab::designer
