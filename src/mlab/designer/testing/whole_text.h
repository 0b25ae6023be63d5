#pragma once

#include <cstdint>
#include <string>

#include "mlab/designer.pb.h"

namespace mlab::designer::testing {

/// The edit after which `document` consists of `text`.
inline EditText whole_text(const Document& document, const std::string& text) {
  EditText edit;
  edit.set_document(document.path());
  edit.set_revision(document.revision());
  edit.set_end(static_cast<std::uint32_t>(document.text().size()));
  edit.set_text(text);
  return edit;
}

}  // namespace mlab::designer::testing
