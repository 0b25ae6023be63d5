#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mlab/designer/drawing/model.h"
#include "mlab/text/diagnostic.h"

// States and transitions that a change speaks of. All of it only reads; what is found points into the model,
// and is gone with the next commit.

namespace mlab::designer {

/// Null: it has no such state.
const cdl::State* state_named(const cdl::Sequence& sequence, std::string_view name);
/// The states of a page.
/// @errors  `cannot-edit`: there is no such page, or it has none
text::Result<const cdl::Sequence*> find_sequence(const Model& model, const std::string& page);
/// @param index  among the transitions of the state `from`
/// @errors       `cannot-edit`: which of page, state and transition there is not
text::Result<const cdl::Transition*> find_transition(const Model& model, const std::string& page,
                                                     const std::string& from, std::uint32_t index);

}  // namespace mlab::designer
