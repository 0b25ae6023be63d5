#pragma once

#include <string>
#include <string_view>

#include "mlab/lang/odl/tree.h"
#include "mlab/overlay/overlay.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/files.h"

namespace mlab::odl {

/// Parses an overlay. One error per broken statement, then it goes on at the next; the tree keeps the broken
/// text, so that `print` loses nothing. Never fails: any bytes give a tree.
Tree parse(const text::SourcePtr& source, text::Diagnostics& sink);

/// Whether `apply` looks at the files that an overlay names (map, height map, waypoint file).
enum class Companions { kRead, kIgnore };

/// Adds to `into` what the tree says: several overlays accumulate, and ORIGIN, HEADING and the like stay in
/// force for the next one. Broken statements are left out. Numbers that are out of range are reported here.
/// Files that it names are looked for beside the overlay and in the current directory; a missing one is a
/// warning.
void apply(const Tree& tree, overlay::Overlay& into, text::Diagnostics& sink,
           Companions companions = Companions::kRead, const text::Files& files = text::files_on_disk());

/// The tree in the canonical layout, comments kept. For a tree without errors: printing what it parses to
/// gives the same text, and it means the same.
std::string print(const Tree& tree);

/// Reads, parses and applies a file. False where there were errors (all in sink).
bool load_overlay(const std::string& path, overlay::Overlay& into, text::Diagnostics& sink,
                  const text::Files& files = text::files_on_disk());

/// Does LOAD-MAP: finds the map-info file `name` beside `near_path` or in the current directory and puts what
/// it says into `into`. Missing files are warnings at `place`; a map-info file that cannot be understood is
/// an error.
void load_map(const std::string& name, const std::string& near_path, const text::Place& place,
              overlay::Overlay& into, text::Diagnostics& sink,
              const text::Files& files = text::files_on_disk());

/// True where the text is an overlay rather than a file of another language.
bool looks_like_odl(std::string_view text);

}  // namespace mlab::odl
