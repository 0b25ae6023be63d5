#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "mlab/designer.pb.h"
#include "mlab/designer/drawing/model.h"

namespace mlab::designer {

/// How a document is known to browsers.
struct DrawingContext {
  std::string document;
  std::uint64_t revision = 0;
  bool is_read_only = false;
  /// The document of a source by its name; empty: it can't be opened.
  std::function<std::string(std::string_view source_name)> document_of;
};

/// A page as it is drawn. A page that is not there gives a drawing without nodes whose `way` is empty.
Drawing draw(const Model& model, const std::string& page, const DrawingContext& context);

/// Those of the file, in the order of the text.
void add_declarations(const Model& model, Document& document);

/// A diagnostic with the page and the node that it speaks of.
Problem problem_of(const text::Diagnostic& diagnostic, const Model& model, const DrawingContext& context);

/// Where a byte of the text is drawn: the page and the node; empty where nowhere.
struct DrawnAt {
  std::string page;
  std::string node;  ///< or the state, or its first transition: `Searching/0`
  std::string port;
};
DrawnAt drawn_at(const Model& model, std::uint32_t byte);

/// All that can be placed: the library's and the file's own components and the operators.
Palette palette_of(const Model& model, const DrawingContext& context);
/// One component of it.
Component palette_entry(const Callable& component, const Model& model, const DrawingContext& context);

}  // namespace mlab::designer
