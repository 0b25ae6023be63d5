#pragma once

#include "source_tree.h"

namespace mlab::repo {

/// Links of Markdown files to files or headings that are not there. Links to other sites are not followed.
Findings dead_links(const Tree& tree);

/// Code blocks that say where they come from and do not stand there word for word. A block says so in the
/// line above its fence: `<!-- from missions/demo_c/demo_c.mdl -->`. Indentation that all of its lines share
/// does not count.
Findings stale_examples(const Tree& tree);

}  // namespace mlab::repo
