#pragma once

#include <map>
#include <set>
#include <string>

#include "source_tree.h"

namespace mlab::repo {

/// Which folders each folder of `web/` may import by itself; what those may import follows.
using WebArrows = std::map<std::string, std::set<std::string, std::less<>>, std::less<>>;

/// The picture that web/README.md describes.
const WebArrows& web_arrows();

/// Imports in `web/` (of types, when needed, of style sheets) from a folder that the importing one must not
/// know. Also names folders that the table does not have, so that a new one is placed on purpose. Files
/// beside `web/README.md` may import everything.
Findings web_imports(const Tree& tree, const WebArrows& arrows = web_arrows());

/// The folders of the table that reach themselves.
std::set<std::string> web_circles(const WebArrows& arrows);

}  // namespace mlab::repo
