#include "mlab/console/overlay_edit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/mission_references.h"
#include "mlab/console/mission_text.h"
#include "mlab/console/odl_statement.h"
#include "mlab/console/scene_encoder.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/token.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/lang/odl/odl.h"
#include "mlab/overlay/random_obstacles.h"
#include "mlab/text/shown.h"

namespace mlab::console {
namespace {

using overlay::MeasureKind;

// What keeps an edit from being made; unwinds to the public functions.
struct Refusal {
  std::string why;
};
[[noreturn]] void refuse(std::string why) {
  throw Refusal{std::move(why)};
}

void refuse_if(const std::string& problem) {
  if (!problem.empty()) refuse(problem);
}

std::vector<text::Span> spans(const auto& tokens) {
  std::vector<text::Span> out;
  for (const auto& token : tokens) {
    if (token.span.end > token.span.begin) out.push_back(token.span);
  }
  return out;
}

odl::Tree parse_overlay(const text::SourcePtr& source) {
  text::Diagnostics unsaid;
  return odl::parse(source, unsaid);
}

mdl::Tree parse_mission(const text::SourcePtr& source) {
  text::Diagnostics unsaid;
  return mdl::parse(source, unsaid);
}

std::vector<mdl::Token> mission_tokens(const text::SourcePtr& source) {
  text::Diagnostics unsaid;
  return mdl::lex(source, unsaid).tokens;
}

struct OverlayDocument {
  explicit OverlayDocument(const text::SourcePtr& source)
      : tree(parse_overlay(source)), splices(source, spans(tree.tokens)) {
    for (std::size_t i = 0; i < tree.statements.size(); ++i) {
      const odl::Statement& statement = tree.statements[i];
      by_place.emplace(statement.span.begin, i);
      if (statement.name.span.end > 0) by_place.emplace(statement.name.span.begin, i);
    }
  }

  odl::Tree tree;
  Splices splices;
  std::optional<geom::Offset> origin;  // once it was asked for
  std::unordered_map<std::uint32_t, std::size_t>
      by_place;  // statements by what map features say of their place
};

struct MissionDocument {
  explicit MissionDocument(const text::SourcePtr& source)
      : tree(parse_mission(source)), tokens(mission_tokens(source)), splices(source, spans(tokens)) {}

  mdl::Tree tree;
  std::vector<mdl::Token> tokens;
  Splices splices;
};

class MapEdit {
 public:
  MapEdit(const MapTexts& texts, const std::string& target)
      : texts_(texts), map_(*texts.map), mission_(texts.mission) {
    for (const MapTexts::OverlayText& overlay : texts.overlays) overlays_.emplace_back(overlay.source);
    for (std::size_t i = 0; i < texts.overlays.size() && !target.empty(); ++i) {
      if (texts.overlays[i].path == target) target_ = i;
    }
    if (!target.empty() && (overlays_.empty() || texts.overlays[target_].path != target))
      refuse(fmt::format("`{}` is no overlay of this mission", text::shown(target, 200)));
    const auto place_of = [this](const text::Place& place) {
      return DocumentPlace{is_editable(place) ? "here" : "", 0};
    };
    scene_obstacles_ = obstacles_in_scene_order(map_, place_of);
  }

  void apply(const MapChange& change) {
    switch (change.change_case()) {
      case MapChange::kAddMeasure:
        add(change.add_measure());
        break;
      case MapChange::kAddObstacle:
        add(change.add_obstacle());
        break;
      case MapChange::kAddObject:
        add(change.add_object());
        break;
      case MapChange::kReplaceMeasure:
        replace_measure(change.replace_measure());
        break;
      case MapChange::kReplaceObstacle:
        replace_obstacle(change.replace_obstacle());
        break;
      case MapChange::kReplaceObject:
        replace_object(change.replace_object());
        break;
      case MapChange::kRemoveMeasure:
        remove_measure(change.remove_measure());
        break;
      case MapChange::kRemoveObstacle:
        remove_obstacle(change.remove_obstacle());
        break;
      case MapChange::kRemoveObject:
        remove_object(change.remove_object());
        break;
      case MapChange::kSetArea:
        set_area(change.set_area());
        break;
      case MapChange::CHANGE_NOT_SET:
        refuse("the change says nothing");
    }
  }

  bool create(const CreateObstacles& request, std::uint32_t seed);
  std::vector<TextEdit> finish();

 private:
  // ---- finding what is to be changed

  bool is_editable(const text::Place& place) const {
    return place.source == texts_.mission || find_overlay(place.source) < overlays_.size();
  }
  std::size_t find_overlay(const text::SourcePtr& source) const {
    const auto found = std::ranges::find(texts_.overlays, source, &MapTexts::OverlayText::source);
    return static_cast<std::size_t>(found - texts_.overlays.begin());
  }

  // The statement of an overlay that a feature of the map stands in; null where that is in the mission.
  const odl::Statement* statement_of(const text::Place& place, OverlayDocument*& document) {
    const std::size_t i = find_overlay(place.source);
    if (i == overlays_.size()) {
      if (place.source == texts_.mission) return nullptr;
      refuse("it stands in a file that is not open, so it can't be edited here");
    }
    document = &overlays_[i];
    const auto found = document->by_place.find(place.span.begin);
    if (found == document->by_place.end()) refuse("its statement was not found");
    touch(place);
    return &document->tree.statements[found->second];
  }

  template <class Kind>
  const Kind& mission_statement(const text::Place& place) {
    touch(place);
    for (const mdl::Statement& statement : mission_.tree.preamble) {
      const Kind* found = std::get_if<Kind>(&statement.what);
      if (found != nullptr && place_of(*found).begin == place.span.begin) return *found;
    }
    refuse("it was made by CREATE-OBSTACLES, so it can't be edited");
  }
  static text::Span place_of(const mdl::statement::StartPlace& start) { return start.name.span; }
  static text::Span place_of(const mdl::statement::Obstacle& obstacle) { return obstacle.x.span; }

  // Two changes of one thing would be about texts that are no longer there.
  void touch(const text::Place& place) {
    if (!touched_.emplace(place.source.get(), place.span.begin).second)
      refuse("one thing is changed twice in one edit");
  }

  const overlay::ControlMeasure& measure(std::uint32_t index) const {
    if (index >= map_.measures.size()) refuse("there is no such place on the map any more");
    return map_.measures[index];
  }
  const overlay::ObstacleDisc& obstacle(std::uint32_t index) const {
    if (index >= scene_obstacles_.size()) refuse("there is no such obstacle on the map any more");
    const overlay::ObstacleDisc& out = map_.obstacles[scene_obstacles_[index]];
    if (!is_written(out)) refuse("it was made by CREATE-OBSTACLES, so it can't be edited");
    return out;
  }
  const overlay::WorldObject& object(std::uint32_t index) const {
    if (index >= map_.objects.size()) refuse("there is no such object on the map any more");
    return map_.objects[index];
  }

  // ---- origins

  // What is added to plain coordinates of the features of an overlay: no ORIGIN follows them.
  geom::Offset origin_of(OverlayDocument& document) {
    if (document.origin) return *document.origin;
    overlay::Overlay state;
    text::Diagnostics unsaid;
    for (const std::uint32_t next : texts_.order) {
      if (next == MapTexts::kMissing) continue;
      odl::Tree only_origins = overlays_[next].tree;
      std::erase_if(only_origins.statements,
                    [](const odl::Statement& s) { return s.keyword != odl::Keyword::kOrigin; });
      odl::apply(only_origins, state, unsaid, odl::Companions::kIgnore);
      if (&overlays_[next] == &document) break;
    }
    document.origin = state.origin;
    return state.origin;
  }

  // ---- where new things go

  void add_to_target(const std::string& statement) {
    OverlayDocument& document = overlays_[target_];
    const bool has_header = std::ranges::any_of(
        document.tree.tokens, [](const odl::Token& token) { return token.kind == odl::TokenKind::kHeader; });
    if (!has_header && !std::exchange(wrote_header_, true))
      document.splices.add_line_at_end("CONTROL MEASURES:");
    document.splices.add_line_at_end(statement);
  }

  geom::Offset target_origin() {
    if (overlays_.empty()) refuse("the mission has no overlay");
    return origin_of(overlays_[target_]);
  }

  // CREATE-OBSTACLES takes the obstacles away that come before it, so new ones go behind it.
  bool is_cleared_behind_target() const {
    bool is_behind = false;
    std::size_t next = 0;
    bool out = false;
    for (const mdl::Statement& statement : mission_.tree.preamble) {
      if (std::holds_alternative<mdl::statement::OverlayFile>(statement.what)) {
        is_behind |= next < texts_.order.size() && texts_.order[next] == target_;
        ++next;
      }
      out |= is_behind && !removes_creation_ &&
             std::holds_alternative<mdl::statement::CreateObstacles>(statement.what);
    }
    return out;
  }

  void add_obstacle_statement(const Obstacle& obstacle) {
    if (!is_target_cleared_) is_target_cleared_ = is_cleared_behind_target();
    if (*is_target_cleared_) {
      mission_lines_.push_back(fmt::format("OBSTACLE {} {}",
                                           brief_point({obstacle.x(), obstacle.y()}, map_.origin),
                                           brief_number(obstacle.radius())));
    } else {
      add_to_target(odl_statement(obstacle, target_origin()));
    }
  }

  void add_to_preamble(const std::string& lines) {
    const auto header = std::ranges::find(mission_.tokens, mdl::TokenKind::kCommandList, &mdl::Token::kind);
    if (header == mission_.tokens.end()) {
      mission_.splices.add_line_at_end(lines);
    } else if (header == mission_.tokens.begin()) {
      mission_.splices.add_line_before(header->span, lines);
    } else {
      mission_.splices.add_line_behind(std::prev(header)->span, lines);
    }
  }

  // ---- the changes

  void add(const Measure& measure) {
    refuse_if(problem_with(measure));
    overlay::ControlMeasure out;
    out.kind = decode_kind(measure.kind());
    out.name = measure.name();
    added_.push_back(std::move(out));
    add_to_target(odl_statement(measure, target_origin()));
  }
  void add(const Obstacle& obstacle) {
    refuse_if(problem_with(obstacle));
    add_obstacle_statement(obstacle);
  }
  void add(const WorldObject& object) {
    refuse_if(problem_with(object));
    add_to_target(odl_statement(object, target_origin()));
  }

  void replace_measure(const ReplaceMeasure& change) {
    refuse_if(problem_with(change.measure()));
    const overlay::ControlMeasure& before = measure(change.index());
    OverlayDocument* document = nullptr;
    const odl::Statement* statement = statement_of(before.place, document);
    if (statement != nullptr) {
      StatementEdit(document->splices, document->tree, *statement, origin_of(*document))
          .replace(before, change.measure());
    } else {
      replace_start_place(before, change.measure());
    }
    renamed_.emplace_back(change.index(), change.measure());
  }

  void replace_start_place(const overlay::ControlMeasure& before, const Measure& after) {
    if (decode_kind(after.kind()) != MeasureKind::kStartPoint)
      refuse("a start place of the mission stays one: remove it, and draw another place");
    const auto& start = mission_statement<mdl::statement::StartPlace>(before.place);
    if (before.name != after.name() || before.shows_label != after.shows_label()) {
      mission_.splices.replace(start.name.span,
                               written_reference(after.shows_label() ? after.name() : after.name() + '*'));
    }
    move(start.x, before.points[0].x, after.points(0).x());
    move(start.y, before.points[0].y, after.points(0).y());
  }

  // A coordinate of the mission; the origin is what it lacks.
  void move(const mdl::Number& number, double before, double after) {
    if (std::abs(before - after) <= kSameNumber) return;
    const double value = after - (before - number.value);
    mission_.splices.replace(number.span, brief_number(std::abs(value) < 0.005 ? 0.0 : value));
  }

  void replace_obstacle(const ReplaceObstacle& change) {
    refuse_if(problem_with(change.obstacle()));
    const overlay::ObstacleDisc& before = obstacle(change.index());
    const Obstacle& after = change.obstacle();
    OverlayDocument* document = nullptr;
    const odl::Statement* statement = statement_of(before.place, document);
    if (statement != nullptr) {
      StatementEdit(document->splices, document->tree, *statement, origin_of(*document))
          .replace(before, after);
      return;
    }
    if (after.height() > 0.0) refuse("an obstacle of the mission has no height: draw one in an overlay");
    const auto& written = mission_statement<mdl::statement::Obstacle>(before.place);
    move(written.x, before.center.x, after.x());
    move(written.y, before.center.y, after.y());
    if (std::abs(before.radius - after.radius()) > kSameNumber)
      mission_.splices.replace(written.radius.span, brief_number(after.radius()));
  }

  void replace_object(const ReplaceObject& change) {
    refuse_if(problem_with(change.object()));
    const overlay::WorldObject& before = object(change.index());
    OverlayDocument* document = nullptr;
    const odl::Statement* statement = statement_of(before.place, document);
    if (statement == nullptr) refuse("its statement was not found");
    StatementEdit(document->splices, document->tree, *statement, origin_of(*document))
        .replace(before, change.object());
  }

  void remove_measure(std::uint32_t index) {
    const overlay::ControlMeasure& before = measure(index);
    OverlayDocument* document = nullptr;
    if (const odl::Statement* statement = statement_of(before.place, document)) {
      document->splices.erase(statement->span);
    } else {
      erase_from_mission(mission_statement<mdl::statement::StartPlace>(before.place).y.span,
                         before.place.span.begin);
    }
    removed_.insert(index);
  }

  void remove_obstacle(std::uint32_t index) { remove(obstacle(index)); }
  void remove(const overlay::ObstacleDisc& before) {
    OverlayDocument* document = nullptr;
    if (const odl::Statement* statement = statement_of(before.place, document)) {
      document->splices.erase(statement->span);
    } else {
      erase_from_mission(mission_statement<mdl::statement::Obstacle>(before.place).radius.span,
                         before.place.span.begin);
    }
  }

  void remove_object(std::uint32_t index) {
    OverlayDocument* document = nullptr;
    const odl::Statement* statement = statement_of(object(index).place, document);
    if (statement == nullptr) refuse("its statement was not found");
    document->splices.erase(statement->span);
  }

  // The statement that ends with this word; its keyword is the last one that begins before `inside`.
  void erase_from_mission(text::Span last_word, std::uint32_t inside) {
    std::uint32_t begin = 0;
    for (const mdl::Statement& statement : mission_.tree.preamble) {
      if (statement.span.begin < inside) begin = std::max(begin, statement.span.begin);
    }
    mission_.splices.erase({begin, last_word.end});
  }

  void set_area(const SetArea& area);
  void write_area(const std::string& size);

  // ---- names

  void rename_references();

  const MapTexts& texts_;
  const overlay::Overlay& map_;
  std::vector<OverlayDocument> overlays_;
  MissionDocument mission_;
  std::size_t target_ = 0;
  std::optional<bool> is_target_cleared_;
  bool wrote_header_ = false;
  bool removes_creation_ = false;
  std::vector<std::uint32_t> scene_obstacles_;
  std::set<std::pair<const text::Source*, std::uint32_t>> touched_;
  std::vector<std::string> mission_lines_;  // for the end of the preamble
  std::vector<overlay::ControlMeasure> added_;
  std::vector<std::pair<std::uint32_t, Measure>> renamed_;
  std::set<std::uint32_t> removed_;
};

// The last statement that sets the area is the one that holds, so that one is changed; a LOAD-MAP behind it
// may set it, too, then the new statement goes behind that.
void MapEdit::set_area(const SetArea& area) {
  for (const double side : {area.width(), area.height()}) {
    if (!(side > 0.0 && side <= 1e8)) refuse("a side of the mission area is longer than 0 metres");
  }
  const std::string width = brief_number(area.width());
  const std::string height = brief_number(area.height());
  struct Setter {
    Splices* splices = nullptr;
    bool is_map = false;
    text::Span first;  // the numbers; of LOAD-MAP its file
    text::Span second;
  };
  std::optional<Setter> last;
  std::size_t next = 0;
  for (const mdl::Statement& statement : mission_.tree.preamble) {
    if (const auto* written = std::get_if<mdl::statement::MissionArea>(&statement.what)) {
      last = {&mission_.splices, false, written->width.span, written->height.span};
    } else if (const auto* map = std::get_if<mdl::statement::LoadMap>(&statement.what)) {
      last = {&mission_.splices, true, map->file.span, {}};
    } else if (std::holds_alternative<mdl::statement::OverlayFile>(statement.what) &&
               next < texts_.order.size()) {
      const std::uint32_t overlay = texts_.order[next++];
      if (overlay == MapTexts::kMissing) continue;
      OverlayDocument& document = overlays_[overlay];
      for (const odl::Statement& each : document.tree.statements) {
        if (each.keyword == odl::Keyword::kMissionArea)
          last = {&document.splices, false, each.numbers[0].span, each.numbers[1].span};
        if (each.keyword == odl::Keyword::kLoadMap) last = {&document.splices, true, each.name.span, {}};
      }
    }
  }
  const std::string line = fmt::format("MISSION-AREA {} {}", width, height);
  if (!last) {
    write_area(line);
  } else if (last->is_map) {
    last->splices->add_line_behind(last->first, line);
  } else {
    last->splices->replace(last->first, width);
    last->splices->replace(last->second, height);
  }
}

void MapEdit::write_area(const std::string& line) {
  if (overlays_.empty()) {
    mission_lines_.push_back(line);
    return;
  }
  OverlayDocument& document = overlays_[target_];
  const auto header = std::ranges::find(document.tree.tokens, odl::TokenKind::kHeader, &odl::Token::kind);
  if (header == document.tree.tokens.end()) {
    document.splices.add_line_at_end(line);
  } else {
    document.splices.add_line_before(header->span, line);
  }
}

// Commands go on meaning what they meant: those of a renamed place get its new name, and no other place may
// get a name that somebody else is called by.
void MapEdit::rename_references() {
  if (renamed_.empty() && added_.empty()) return;
  overlay::Overlay changed;
  changed.measures = map_.measures;
  for (const auto& [index, after] : renamed_) {
    changed.measures[index].name = after.name();
    changed.measures[index].kind = decode_kind(after.kind());
  }
  const std::string gone = "\n";  // no name has a line end
  for (const std::uint32_t index : removed_) changed.measures[index].name = gone;
  changed.measures.insert(changed.measures.end(), added_.begin(), added_.end());
  for (const PlaceReference& reference : place_references(mission_.tree, map_)) {
    if (removed_.contains(reference.measure)) continue;
    const overlay::ControlMeasure& meant = changed.measures[reference.measure];
    const bool is_renamed = meant.name != map_.measures[reference.measure].name;
    if (!is_renamed) {
      if (overlay::find_measure(changed, reference.name) != &meant)
        refuse(fmt::format("`{}` would mean another place then: take another name", reference.name));
      continue;
    }
    const std::string name =
        meant.name.empty() ? "" : renamed_reference(reference, changed, reference.measure);
    if (name.empty())
      refuse(
          fmt::format("commands go to `{}`, and could not by that name: take another one", reference.name));
    mission_.splices.replace(reference.word, name);
  }
}

bool MapEdit::create(const CreateObstacles& request, std::uint32_t seed) {
  const double least = request.min_radius();
  const double most = request.max_radius();
  if (!(request.coverage_percent() >= 0.0 && request.coverage_percent() <= 30.0))
    refuse("obstacles cover 0 to 30 per cent of the area");
  if (!(least > 0.0 && least <= 1e6 && most > 0.0 && most <= 1e6)) refuse("a radius is more than 0");
  const overlay::Area area = map_.mission_area();
  const overlay::ObstacleField field{request.coverage_percent(), least, most};
  overlay::CreatedObstacles created;
  if (request.replace()) {
    for (const mdl::Statement& statement : mission_.tree.preamble) {
      if (std::holds_alternative<mdl::statement::CreateObstacles>(statement.what))
        mission_.splices.erase(statement.span);
    }
    removes_creation_ = true;
    for (const overlay::ObstacleDisc& each : map_.obstacles) {
      const bool is_repeated = touched_.contains({each.place.source.get(), each.place.span.begin});
      if (is_written(each) && is_editable(each.place) && !is_repeated) remove(each);
    }
    created = overlay::create_obstacles(area, field, seed);
  } else {
    const overlay::Region region{{0.0, 0.0}, {area.width, area.height}};
    double covered = 0.0;
    for (const overlay::ObstacleDisc& each : map_.obstacles) {
      if (region.contains(each.center)) covered += std::numbers::pi * each.radius * each.radius;
    }
    created = overlay::create_obstacles(region, field, seed, covered, map_.obstacles);
  }
  for (const overlay::ObstacleDisc& each : created.obstacles) {
    Obstacle obstacle;
    obstacle.set_x(each.center.x);
    obstacle.set_y(each.center.y);
    obstacle.set_radius(each.radius);
    add_obstacle_statement(obstacle);
  }
  return created.is_complete;
}

std::vector<TextEdit> MapEdit::finish() {
  rename_references();
  if (!mission_lines_.empty()) {
    std::string lines;
    for (const std::string& line : mission_lines_) lines += (lines.empty() ? "" : "\n") + line;
    add_to_preamble(lines);
  }
  std::vector<TextEdit> out;
  const auto take = [&](const Splices& splices) {
    if (splices.is_empty()) return;
    const std::optional<Splice> joined = splices.joined();
    if (!joined) refuse("two changes of this edit are about the same words");
    out.push_back({splices.source(), *joined});
  };
  take(mission_.splices);
  for (const OverlayDocument& document : overlays_) take(document.splices);
  return out;
}

template <class Make>
text::Result<std::vector<TextEdit>> made(Make make) {
  try {
    return make();
  } catch (const Refusal& refusal) {
    return std::unexpected(
        text::Diagnostic{text::Severity::kError, "cannot-edit", refusal.why, {}, {}, {}, {}});
  }
}

}  // namespace

text::Result<std::vector<TextEdit>> edit_map(const MapTexts& texts,
                                             const google::protobuf::RepeatedPtrField<MapChange>& changes,
                                             const std::string& target) {
  return made([&] {
    MapEdit edit(texts, target);
    for (const MapChange& change : changes) edit.apply(change);
    return edit.finish();
  });
}

text::Result<std::vector<TextEdit>> create_obstacles(const MapTexts& texts, const CreateObstacles& request,
                                                     std::uint32_t seed, bool& is_complete) {
  return made([&] {
    MapEdit edit(texts, "");
    is_complete = edit.create(request, seed);
    return edit.finish();
  });
}

}  // namespace mlab::console
