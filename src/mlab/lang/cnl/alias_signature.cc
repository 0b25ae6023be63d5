#include "mlab/lang/cnl/alias_signature.h"

namespace mlab::cnl {
namespace {

AliasSignature::Port alias_port_of(const AliasDecl& alias, const InputDecl& input) {
  AliasSignature::Port out{"", input.unit.text};
  for (const AliasPort& port : alias.ports) {
    if (port.input.text != input.name.text) continue;
    out.name += (out.name.empty() ? "" : "|") + port.name.text;
    if (!port.unit.text.empty()) out.unit = port.unit.text;
  }
  if (out.name.empty()) out.name = input.name.text;
  return out;
}

}  // namespace

AliasSignature signature_of(const Procedure& procedure, const AliasDecl& alias) {
  AliasSignature out;
  for (const InputDecl& input : procedure.inputs) out.inputs.push_back(alias_port_of(alias, input));
  for (const AliasPort& port : alias.ports) {
    if (port.input.text == "none") out.ignored.push_back(port.name.text);
  }
  const Word& unit = alias.output_unit.text.empty() ? procedure.output_unit : alias.output_unit;
  out.output_unit = unit.text;
  return out;
}

}  // namespace mlab::cnl
