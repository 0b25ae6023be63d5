#include "mlab/lang/odl/testing/check_print.h"

#include <memory>
#include <vector>

#include <fmt/core.h>

#include "mlab/lang/odl/odl.h"

namespace mlab::odl {
namespace {

std::vector<std::string> comments_of(const Tree& tree) {
  std::vector<std::string> out;
  for (const Comment& comment : tree.comments) out.emplace_back(tree.source->text(comment.span));
  return out;
}

// Everything an overlay says, as text. Numbers with all their digits.
std::string meaning_of(const Tree& tree) {
  text::Diagnostics sink;
  overlay::Overlay o;
  apply(tree, o, sink, Companions::kIgnore);
  std::string out = fmt::format("{}|{}|{} {}|{}|{}|{}", o.scenario, o.site, o.origin.x, o.origin.y, o.heading,
                                o.map_file, sink.error_count());
  if (o.utm_origin) out += fmt::format("|utm {} {}", o.utm_origin->offset.x, o.utm_origin->offset.y);
  if (o.projection)
    out += fmt::format("|earth {} {} {}", o.projection->central_meridian_deg, o.projection->origin.x,
                       o.projection->origin.y);
  if (o.area) out += fmt::format("|area {} {}", o.area->width, o.area->height);
  if (o.global_reference) out += fmt::format("|ref {} {}", o.global_reference->x, o.global_reference->y);
  if (o.height_map)
    out += fmt::format("|{} {} {}", o.height_map->file, o.height_map->columns, o.height_map->z_scale);
  out += fmt::format("|{} {}\n", o.scale.value_or(-1.0), o.zoom_percent.value_or(-1.0));
  for (const auto& m : o.measures) {
    out += fmt::format("{} `{}` {} {}", overlay::keyword(m.kind), m.name, m.shows_label, m.size);
    for (const auto* points : {&m.points, &m.centerline}) {
      for (const geom::Point& p : *points) out += fmt::format(" {},{}", p.x, p.y);
      out += ';';
    }
    out += '\n';
  }
  for (const auto& d : o.obstacles) {
    out += fmt::format("{} {} {} {} {}", d.center.x, d.center.y, d.radius, d.height, d.speed);
    for (const geom::Point& p : d.route) out += fmt::format(" {},{}", p.x, p.y);
    out += '\n';
  }
  for (const auto& w : o.objects) {
    out += fmt::format("{} {} {} {} {}\n", w.center.x, w.center.y, w.diameter, static_cast<int>(w.style),
                       w.color);
  }
  return out;
}

}  // namespace

std::string what_print_changes(std::string_view text, bool& had_errors) {
  text::Diagnostics sink;
  const Tree tree = parse(std::make_shared<const text::Source>("before", std::string(text)), sink);
  const std::string printed = print(tree);
  had_errors = sink.has_errors();
  const std::string meaning = meaning_of(tree);
  if (had_errors) return "";
  text::Diagnostics again_sink;
  const Tree again = parse(std::make_shared<const text::Source>("after", printed), again_sink);
  if (again_sink.error_count() + again_sink.warning_count() > 0)
    return "complaints: " + text::render(again_sink) + printed;
  if (print(again) != printed) return "layout:\n" + printed + "\nbecomes\n" + print(again);
  if (comments_of(again) != comments_of(tree)) return "comments:\n" + printed;
  if (meaning_of(again) != meaning) return "meaning:\n" + meaning + "becomes\n" + meaning_of(again);
  return "";
}

}  // namespace mlab::odl
