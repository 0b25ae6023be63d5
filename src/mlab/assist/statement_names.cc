#include "mlab/assist/statement_names.h"

#include <algorithm>
#include <filesystem>

#include "mlab/lang/mdl/token.h"

namespace mlab::assist {

text::Span bare_name(const text::SourcePtr& source, text::Span span) {
  std::string_view text = source->text(span);
  if (text.starts_with('"')) {
    ++span.begin;
    text.remove_prefix(1);
    if (text.ends_with('"')) {
      --span.end;
      text.remove_suffix(1);
    }
  }
  if (text.ends_with('*') && span.end > span.begin) --span.end;
  return span;
}

text::Span own_part(const text::SourcePtr& source, text::Span span, const overlay::ControlMeasure& measure) {
  const text::Span bare = bare_name(source, span);
  const std::string_view text = source->text(bare);
  const auto size = static_cast<std::uint32_t>(measure.name.size());
  if (text.size() > size && mdl::equal_without_case(text.substr(text.size() - size), measure.name))
    return {bare.end - size, bare.end};
  return bare;
}

std::optional<MeantRobot> robot_meant(const std::string& program, const std::string& type_name,
                                      const std::string& folder, const Surroundings& around) {
  const std::size_t hash = program.rfind('#');
  MeantRobot out;
  out.file = program.substr(0, hash);
  const std::string wanted = hash == std::string::npos ? "" : program.substr(hash + 1);
  if (!out.file.ends_with(".cdl") || out.file.find('\0') != std::string::npos) return std::nullopt;
  const auto source = around.files.read((std::filesystem::path(folder) / out.file).string());
  if (!source) return std::nullopt;
  out.scan = scan_cdl(*source);
  const CdlDeclaration* only = nullptr;
  int robots = 0;
  for (const CdlDeclaration& one : out.scan.declarations) {
    if (one.kind == NameKind::kSociety && one.name == wanted) out.society = &one;
    if (one.kind != NameKind::kRobot) continue;
    ++robots;
    only = &one;
    const bool is_it = wanted.empty() ? mdl::equal_without_case(one.name, type_name) : one.name == wanted;
    if (is_it) out.robot = &one;
  }
  if (out.robot == nullptr && wanted.empty() && robots == 1) out.robot = only;
  for (const CdlDeclaration& one : out.scan.declarations) {
    if (out.robot != nullptr && one.kind == NameKind::kClass && one.name == out.robot->class_name)
      out.robot_class = &one;
  }
  return out;
}

const CdlParameter* find_parameter(const MeantRobot& in, const std::string& name) {
  for (const CdlDeclaration* declaration : {in.robot, in.robot_class}) {
    if (declaration == nullptr) continue;
    for (const CdlParameter& one : declaration->parameters) {
      if (one.input.name == name) return &one;
    }
  }
  return nullptr;
}

std::string folder_of(const Text& text) {
  return std::filesystem::path(text.source->name()).parent_path().string();
}

}  // namespace mlab::assist
