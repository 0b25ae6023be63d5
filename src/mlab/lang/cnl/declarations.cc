#include "mlab/lang/cnl/declarations.h"

#include <algorithm>
#include <span>
#include <utility>

#include "mlab/lang/cnl/cpp_writer.h"

namespace mlab::cnl {
namespace {

void blank(const Code& code, std::string& text) {
  const std::span piece = std::span(text).subspan(code.place.span.begin, code.text().size());
  std::ranges::replace_if(piece, [](char c) { return c != '\n' && c != '\r'; }, ' ');
}

void add(const Tree& tree, std::vector<Declarations>& out) {
  std::string text(tree.source->text());
  for (const Item& item : tree.items) {
    if (const auto* init = std::get_if<Init>(&item)) blank(init->code, text);
    if (const auto* include = std::get_if<Include>(&item); include != nullptr && include->tree)
      add(*include->tree, out);
    const auto* procedure = std::get_if<Procedure>(&item);
    if (procedure == nullptr) continue;
    for (const std::optional<Code>& code : {procedure->once, procedure->header, procedure->body}) {
      if (code) blank(*code, text);
    }
  }
  out.push_back({std::string(base_name(tree.source->name())), std::move(text)});
}

}  // namespace

std::vector<Declarations> declarations_of(const Tree& tree) {
  std::vector<Declarations> out;
  add(tree, out);
  return out;
}

}  // namespace mlab::cnl
