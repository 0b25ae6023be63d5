#include "mlab/console/documents/check_text.h"

#include <memory>

#include "mlab/lang/odl/odl.h"

namespace mlab::console {

text::Diagnostics check_text(const Check& request, const mission::Mission* mission, const std::string& folder,
                             const mdl::LoadOptions& options) {
  text::Diagnostics out;
  if (request.language() == Complete::IMMEDIATE) {
    const mission::Mission nothing;
    mdl::parse_immediate(request.text(), mission != nullptr ? *mission : nothing, out, options);
    return out;
  }
  const auto source = std::make_shared<const text::Source>("text", request.text());
  if (request.language() == Complete::OVERLAY) {
    overlay::Overlay map;
    odl::apply(odl::parse(source, out), map, out, odl::Companions::kRead, options.files);
  } else {
    mdl::check_mission(source, folder, out, options);
  }
  return out;
}

}  // namespace mlab::console
