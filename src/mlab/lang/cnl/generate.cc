#include "mlab/lang/cnl/generate.h"

#include <algorithm>
#include <cstdint>

#include <fmt/core.h>

#include "mlab/lang/cnl/check.h"
#include "mlab/lang/cnl/cpp_writer.h"
#include "mlab/lang/cnl/procedure_code.h"

namespace mlab::cnl {
namespace {

std::string identifier(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    const bool fits = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    if (!fits) c = '_';
  }
  return out;
}

void write_init(CppWriter& out, const Init& init) {
  out.user_code(init.code);
}

// A type of the author's own flows once it has a name, a size and nothing that points elsewhere.
void write_type(CppWriter& out, const TypeDecl& type) {
  if (find_port_type(type.name.text)) return;
  out.line("template <>");
  out.line("struct mlab::flow::PortTraits<");
  out.at(type.name.place, fmt::format("::{}", type.name.text));
  out.line("> {");
  out.line("  static const mlab::flow::TypeInfo& info() {");
  out.line(
      fmt::format("    static constexpr mlab::flow::TypeInfo kInfo{{.name = {}, .size = sizeof(::{}), "
                  ".alignment = alignof(::{})}};",
                  cpp_string(type.name.text), type.name.text, type.name.text));
  out.line("    return kInfo;");
  out.line("  }");
  out.line("};");
  out.line("namespace mlab_cnl {");
  out.line("static_assert(");
  out.at(type.name.place, fmt::format("is_state<::{}>,", type.name.text));
  out.line(fmt::format(
      "{});", cpp_string(fmt::format(
                  "values of the type `{}` cannot be copied byte by byte, as values on wires have to be",
                  type.name.text))));
  out.line("}");
}

std::vector<const Procedure*> own_procedures(const Tree& tree) {
  std::vector<const Procedure*> out = items_of<Procedure>(tree);
  std::erase_if(out, [](const Procedure* p) { return p->is_external; });
  return out;
}

void write_module_entry(CppWriter& out, std::string_view function) {
  out.line("");
  out.line(R"(extern "C" [[gnu::visibility("default")]] const mlab::flow::Module* mlab_cnl_module_v1() {)");
  out.line(
      fmt::format("  static const mlab::flow::Module kModule = mlab::flow::make_module({}());", function));
  out.line("  return &kModule;");
  out.line("}");
}

}  // namespace

std::string stem_of(std::string_view cnl_file) {
  if (const std::size_t slash = cnl_file.rfind('/'); slash != std::string_view::npos)
    cnl_file.remove_prefix(slash + 1);
  if (const std::size_t dot = cnl_file.rfind('.'); dot != std::string_view::npos && dot > 0)
    cnl_file = cnl_file.substr(0, dot);
  return identifier(cnl_file);
}

std::string generate(const Tree& tree, const GenerateOptions& options) {
  CppWriter out(options.output_name);
  out.line(fmt::format("// Made from {} by cnlc. Changes belong there.", base_name(tree.source->name())));
  out.line("#include \"mlab/schema/procedure.h\"");
  out.line("");
  out.line("#include \"mlab/flow/firing.h\"");
  if (options.is_module) out.line("#include \"mlab/flow/module.h\"");
  out.line("");
  // Inputs come in again as parameters of the body; a procedure's own variables may have names of the
  // library.
  out.line("#pragma GCC diagnostic ignored \"-Wshadow\"");
  // Short, so that compilers name the place of what they check and not one beside it.
  out.line("namespace mlab_cnl { using mlab::flow::is_state; }");
  visit_items(tree, [&](const Item& item) {
    if (const auto* init = std::get_if<Init>(&item)) write_init(out, *init);
  });
  std::vector<std::string> written;
  visit_items(tree, [&](const Item& item) {
    const auto* type = std::get_if<TypeDecl>(&item);
    if (!type || std::ranges::find(written, type->name.text) != written.end()) return;
    write_type(out, *type);
    written.push_back(type->name.text);
  });
  const std::vector<const Procedure*> procedures = own_procedures(tree);
  const std::string stem = stem_of(tree.source->name());
  // A file may be called `class.cnl` or `1st.cnl`: its name alone is no name of C++.
  const std::string file_space = "f_" + stem;
  std::vector<std::string> spaces;
  for (const Procedure* procedure : procedures) {
    spaces.push_back(fmt::format("p{}_{}", spaces.size() + 1, identifier(procedure->name.text)));
    out.line("");
    out.line(fmt::format("namespace mlab_cnl::{}::{} {{", file_space, spaces.back()));
    write_procedure(out, *procedure);
    out.line("}");
  }
  const std::string function = fmt::format("mlab_cnl_{}", stem);
  out.line("");
  out.line(fmt::format("std::span<const mlab::flow::Behavior* const> {}();", function));
  out.line(fmt::format("std::span<const mlab::flow::Behavior* const> {}() {{", function));
  if (spaces.empty()) {
    out.line("  return {};");
  } else {
    out.line("  static const mlab::flow::Behavior* const kAll[] = {");
    for (const std::string& space : spaces)
      out.line(fmt::format("      &mlab_cnl::{}::{}::behavior(),", file_space, space));
    out.line("  };");
    out.line("  return kAll;");
  }
  out.line("}");
  if (options.is_module) write_module_entry(out, function);
  return std::move(out).text();
}

std::string generate_table(const std::vector<std::string>& cnl_files, std::string_view name) {
  std::string out =
      "// Made by cnlc: all procedures of these files in one list.\n#include <span>\n#include <vector>\n\n";
  out += "#include \"mlab/flow/behavior.h\"\n\n";
  std::vector<std::string> functions;
  for (const std::string& file : cnl_files) functions.push_back(fmt::format("mlab_cnl_{}", stem_of(file)));
  for (const std::string& function : functions) {
    out += fmt::format("std::span<const mlab::flow::Behavior* const> {}();\n", function);
  }
  out += fmt::format("\nstd::span<const mlab::flow::Behavior* const> {}();\n", name);
  out += fmt::format("std::span<const mlab::flow::Behavior* const> {}() {{\n", name);
  out += "  static const std::vector<const mlab::flow::Behavior*> kAll = [] {\n";
  out += "    std::vector<const mlab::flow::Behavior*> all;\n";
  for (const std::string& function : functions) {
    out += fmt::format("    for (const mlab::flow::Behavior* b : {}()) all.push_back(b);\n", function);
  }
  out += "    return all;\n  }();\n  return kAll;\n}\n";
  return out;
}

}  // namespace mlab::cnl
