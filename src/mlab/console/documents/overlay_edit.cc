#include "mlab/console/documents/overlay_edit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/documents/mission_references.h"
#include "mlab/console/documents/mission_text.h"
#include "mlab/console/documents/odl_statement.h"
#include "mlab/console/published/scene_encoder.h"
#include "mlab/documents/refused.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/token.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/lang/mdl/words.h"
#include "mlab/lang/odl/odl.h"
#include "mlab/lang/odl/write.h"
#include "mlab/overlay/random_obstacles.h"
#include "mlab/text/shown.h"

namespace mlab::console {
namespace {

using overlay::MeasureKind;

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
      : tree(parse_overlay(source)), words(source, spans(tree.tokens)) {
    for (std::size_t i = 0; i < tree.statements.size(); ++i) {
      const odl::Statement& statement = tree.statements[i];
      by_place.emplace(statement.span.begin, i);
      if (statement.name.span.end > 0) by_place.emplace(statement.name.span.begin, i);
    }
  }

  odl::Tree tree;
  text::WordChanges words;
  std::optional<geom::Offset> origin;  // once it was asked for
  std::unordered_map<std::uint32_t, std::size_t>
      by_place;  // statements by what map features say of their place
};

struct MissionDocument {
  explicit MissionDocument(const text::SourcePtr& source)
      : tree(parse_mission(source)), tokens(mission_tokens(source)), words(source, spans(tokens)) {}

  mdl::Tree tree;
  std::vector<mdl::Token> tokens;
  text::WordChanges words;
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
  /// All changes as one for each text.
  text::Result<std::vector<TextEdit>> finish();

 private:
  // ---- finding what is to be changed

  bool is_editable(const text::Place& place) const {
    return place.source == texts_.mission || find_overlay(place.source) < overlays_.size();
  }
  std::size_t find_overlay(const text::SourcePtr& source) const {
    const auto found = std::ranges::find(texts_.overlays, source, &MapTexts::OverlayText::source);
    return static_cast<std::size_t>(found - texts_.overlays.begin());
  }

  /// Where a feature of the map is said.
  struct FeatureStatements {
    OverlayDocument* overlay = nullptr;
    const odl::Statement* in_overlay = nullptr;
    const mdl::Statement* in_mission = nullptr;
  };

  // Two changes of one thing would be about texts that are no longer there, so each is found once.
  FeatureStatements find(const text::Place& place) {
    if (!touched_.emplace(place.source.get(), place.span.begin).second) {
      refuse("one thing is changed twice in one edit");
      return {};
    }
    if (place.source == texts_.mission) return find_in_mission(place.span.begin);
    const std::size_t i = find_overlay(place.source);
    if (i == overlays_.size()) {
      refuse("it stands in a file that is not open, so it can't be edited here");
      return {};
    }
    const auto found = overlays_[i].by_place.find(place.span.begin);
    if (found != overlays_[i].by_place.end())
      return {&overlays_[i], &overlays_[i].tree.statements[found->second], nullptr};
    refuse("its statement was not found");
    return {};
  }

  FeatureStatements find_in_mission(std::uint32_t begin) {
    for (const mdl::Statement& statement : mission_.tree.preamble) {
      const auto* start = std::get_if<mdl::statement::StartPlace>(&statement.what);
      const auto* obstacle = std::get_if<mdl::statement::Obstacle>(&statement.what);
      const bool is_it = (start != nullptr && start->name.span.begin == begin) ||
                         (obstacle != nullptr && obstacle->x.span.begin == begin);
      if (is_it) return {nullptr, nullptr, &statement};
    }
    refuse("it was made by CREATE-OBSTACLES, so it can't be edited");
    return {};
  }

  // Null where there is none; the edit is refused then.
  const overlay::ControlMeasure* measure(std::uint32_t index) {
    if (index < map_.measures.size()) return &map_.measures[index];
    refuse("there is no such place on the map any more");
    return nullptr;
  }
  const overlay::ObstacleDisc* obstacle(std::uint32_t index) {
    if (index >= scene_obstacles_.size()) {
      refuse("there is no such obstacle on the map any more");
      return nullptr;
    }
    const overlay::ObstacleDisc& out = map_.obstacles[scene_obstacles_[index]];
    if (is_written(out)) return &out;
    refuse("it was made by CREATE-OBSTACLES, so it can't be edited");
    return nullptr;
  }
  const overlay::WorldObject* object(std::uint32_t index) {
    if (index < map_.objects.size()) return &map_.objects[index];
    refuse("there is no such object on the map any more");
    return nullptr;
  }

  // ---- what can't be done

  /// The edit is not made; what was said first is told.
  void refuse(std::string why) {
    if (refusal_.empty()) refusal_ = std::move(why);
  }
  /// @param thing  Measure, Obstacle or WorldObject
  bool can_be_written(const auto& thing) {
    const std::string problem = problem_with(thing);
    if (!problem.empty()) refuse(problem);
    return problem.empty();
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

  void add_to_target(const auto& thing) {
    if (overlays_.empty()) {
      refuse("the mission has no overlay");
      return;
    }
    OverlayDocument& document = overlays_[target_];
    const bool has_header = std::ranges::any_of(
        document.tree.tokens, [](const odl::Token& token) { return token.kind == odl::TokenKind::kHeader; });
    if (!has_header && !std::exchange(wrote_header_, true))
      document.words.add_line_at_end("CONTROL MEASURES:");
    document.words.add_line_at_end(odl::print(statement_of(thing, origin_of(document))));
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
      if (!obstacle.route().empty())
        refuse("an obstacle of the mission has no route: CREATE-OBSTACLES takes those of the overlay away");
      mission_lines_.push_back(
          mdl::print({{},
                      {},
                      mdl::statement::Obstacle{new_number(coordinate(obstacle.x() - map_.origin.x)),
                                               new_number(coordinate(obstacle.y() - map_.origin.y)),
                                               new_number(obstacle.radius())}}));
    } else {
      add_to_target(obstacle);
    }
  }

  void add_to_preamble(const std::string& lines) {
    const auto header = std::ranges::find(mission_.tokens, mdl::TokenKind::kCommandList, &mdl::Token::kind);
    if (header == mission_.tokens.end()) {
      mission_.words.add_line_at_end(lines);
    } else if (header == mission_.tokens.begin()) {
      mission_.words.add_line_before(header->span, lines);
    } else {
      mission_.words.add_line_behind(std::prev(header)->span, lines);
    }
  }

  // ---- the changes

  void add(const Measure& measure) {
    if (!can_be_written(measure)) return;
    overlay::ControlMeasure out;
    out.kind = decode_kind(measure.kind());
    out.name = measure.name();
    added_.push_back(std::move(out));
    add_to_target(measure);
  }
  void add(const Obstacle& obstacle) {
    if (can_be_written(obstacle)) add_obstacle_statement(obstacle);
  }
  void add(const WorldObject& object) {
    if (can_be_written(object)) add_to_target(object);
  }

  static void reword(const FeatureStatements& where, const odl::Statement& now) {
    where.overlay->words.reword(now.span, odl::words_of(now, where.overlay->tree));
  }
  template <class Kind>
  void reword(const FeatureStatements& where, const Kind& was, const Kind& now) {
    const text::Span keyword = where.in_mission->span;
    const text::Span last = mdl::words_of(was, keyword).back().from.value_or(keyword);
    mission_.words.reword({keyword.begin, last.end}, mdl::words_of(now, keyword));
  }

  void replace_measure(const ReplaceMeasure& change) {
    const overlay::ControlMeasure* before = measure(change.index());
    if (before == nullptr || !can_be_written(change.measure())) return;
    const FeatureStatements where = find(before->place);
    if (where.in_overlay != nullptr)
      reword(where, changed(*where.in_overlay, *before, change.measure(), origin_of(*where.overlay)));
    if (where.in_mission != nullptr) replace_start_place(where, *before, change.measure());
    renamed_.emplace_back(change.index(), change.measure());
  }

  void replace_start_place(const FeatureStatements& where, const overlay::ControlMeasure& before,
                           const Measure& after) {
    if (decode_kind(after.kind()) != MeasureKind::kStartPoint) {
      refuse("a start place of the mission stays one: remove it, and draw another place");
      return;
    }
    const auto* was = std::get_if<mdl::statement::StartPlace>(&where.in_mission->what);
    if (was == nullptr) return;
    mdl::statement::StartPlace now = *was;
    if (before.name != after.name() || before.shows_label != after.shows_label())
      now.name = {written_reference(after.shows_label() ? after.name() : after.name() + '*'), false, {}};
    now.x = moved(was->x, before.points[0].x, after.points(0).x());
    now.y = moved(was->y, before.points[0].y, after.points(0).y());
    reword(where, *was, now);
  }

  static mdl::Number new_number(double value) { return {value, odl::written(value), {}}; }
  // A coordinate of the mission; the origin is what it lacks.
  static mdl::Number moved(const mdl::Number& was, double before, double after) {
    if (std::abs(before - after) <= kSameNumber) return was;
    return new_number(coordinate(after - (before - was.value)));
  }

  void replace_obstacle(const ReplaceObstacle& change) {
    const Obstacle& after = change.obstacle();
    const overlay::ObstacleDisc* before = obstacle(change.index());
    if (before == nullptr || !can_be_written(after)) return;
    const FeatureStatements where = find(before->place);
    if (where.in_overlay != nullptr)
      reword(where, changed(*where.in_overlay, *before, after, origin_of(*where.overlay)));
    if (where.in_mission == nullptr) return;
    if (after.height() > 0.0) refuse("an obstacle of the mission has no height: draw one in an overlay");
    const auto* was = std::get_if<mdl::statement::Obstacle>(&where.in_mission->what);
    if (was == nullptr) return;
    mdl::statement::Obstacle now = *was;
    now.x = moved(was->x, before->center.x, after.x());
    now.y = moved(was->y, before->center.y, after.y());
    if (std::abs(before->radius - after.radius()) > kSameNumber) now.radius = new_number(after.radius());
    reword(where, *was, now);
  }

  void replace_object(const ReplaceObject& change) {
    const overlay::WorldObject* before = object(change.index());
    if (before == nullptr || !can_be_written(change.object())) return;
    const FeatureStatements where = find(before->place);
    if (where.in_overlay != nullptr)
      reword(where, changed(*where.in_overlay, *before, change.object(), origin_of(*where.overlay)));
  }

  void remove_measure(std::uint32_t index) {
    if (const overlay::ControlMeasure* before = measure(index)) remove(before->place);
    removed_.insert(index);
  }
  void remove_obstacle(std::uint32_t index) {
    if (const overlay::ObstacleDisc* before = obstacle(index)) remove(before->place);
  }
  void remove_object(std::uint32_t index) {
    if (const overlay::WorldObject* before = object(index)) remove(before->place);
  }

  void remove(const text::Place& place) {
    const FeatureStatements where = find(place);
    if (where.in_overlay != nullptr) where.overlay->words.erase(where.in_overlay->span);
    if (where.in_mission == nullptr) return;
    const text::Span keyword = where.in_mission->span;
    const auto erase = [&](const auto& what) {
      mission_.words.erase({keyword.begin, mdl::words_of(what, keyword).back().from.value_or(keyword).end});
    };
    if (const auto* start = std::get_if<mdl::statement::StartPlace>(&where.in_mission->what)) erase(*start);
    if (const auto* obstacle = std::get_if<mdl::statement::Obstacle>(&where.in_mission->what))
      erase(*obstacle);
  }

  void set_area(const SetArea& area);
  void add_area(const mdl::Statement& area);

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
  std::string refusal_;  // empty: the edit can be made
};

// The last statement that sets the area is the one that holds, so that one is changed; a LOAD-MAP behind it
// may set it, too, then the new statement goes behind that.
void MapEdit::set_area(const SetArea& area) {
  for (const double side : {area.width(), area.height()}) {
    if (!(side > 0.0 && side <= 1e8)) refuse("a side of the mission area is longer than 0 metres");
  }
  const text::Word width{odl::written(area.width()), std::nullopt};
  const text::Word height{odl::written(area.height()), std::nullopt};
  const mdl::Statement statement{
      {}, {}, mdl::statement::MissionArea{new_number(area.width()), new_number(area.height())}};
  struct Setter {
    text::WordChanges* words = nullptr;
    bool is_map = false;
    text::Span numbers;  // of LOAD-MAP its file
  };
  std::optional<Setter> last;
  std::size_t next = 0;
  for (const mdl::Statement& each : mission_.tree.preamble) {
    if (const auto* written = std::get_if<mdl::statement::MissionArea>(&each.what)) {
      last = {&mission_.words, false, {written->width.span.begin, written->height.span.end}};
    } else if (const auto* map = std::get_if<mdl::statement::LoadMap>(&each.what)) {
      last = {&mission_.words, true, map->file.span};
    } else if (std::holds_alternative<mdl::statement::OverlayFile>(each.what) && next < texts_.order.size()) {
      const std::uint32_t overlay = texts_.order[next++];
      if (overlay == MapTexts::kMissing) continue;
      OverlayDocument& document = overlays_[overlay];
      for (const odl::Statement& one : document.tree.statements) {
        if (one.keyword == odl::Keyword::kMissionArea)
          last = {&document.words, false, {one.numbers[0].span.begin, one.numbers[1].span.end}};
        if (one.keyword == odl::Keyword::kLoadMap) last = {&document.words, true, one.name.span};
      }
    }
  }
  if (!last)
    add_area(statement);
  else if (last->is_map)
    last->words->add_line_behind(last->numbers, mdl::print(statement));
  else
    last->words->reword(last->numbers, {width, height});
}

// Both languages say it in the same words.
void MapEdit::add_area(const mdl::Statement& area) {
  const std::string line = mdl::print(area);
  if (overlays_.empty()) {
    mission_lines_.push_back(line);
    return;
  }
  OverlayDocument& document = overlays_[target_];
  const auto header = std::ranges::find(document.tree.tokens, odl::TokenKind::kHeader, &odl::Token::kind);
  if (header == document.tree.tokens.end())
    document.words.add_line_at_end(line);
  else
    document.words.add_line_before(header->span, line);
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
    else
      mission_.words.replace(reference.word, name);
  }
}

bool MapEdit::create(const CreateObstacles& request, std::uint32_t seed) {
  const double least = request.min_radius();
  const double most = request.max_radius();
  if (!(request.coverage_percent() >= 0.0 && request.coverage_percent() <= 30.0))
    refuse("obstacles cover 0 to 30 per cent of the area");
  if (!(least > 0.0 && least <= 1e6 && most > 0.0 && most <= 1e6)) refuse("a radius is more than 0");
  if (!refusal_.empty()) return true;
  const overlay::Area area = map_.mission_area();
  const overlay::ObstacleField field{request.coverage_percent(), least, most};
  overlay::CreatedObstacles created;
  if (request.replace()) {
    for (const mdl::Statement& statement : mission_.tree.preamble) {
      if (std::holds_alternative<mdl::statement::CreateObstacles>(statement.what))
        mission_.words.erase(statement.span);
    }
    removes_creation_ = true;
    for (const overlay::ObstacleDisc& each : map_.obstacles) {
      const bool is_repeated = touched_.contains({each.place.source.get(), each.place.span.begin});
      if (is_written(each) && is_editable(each.place) && !is_repeated) remove(each.place);
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

text::Result<std::vector<TextEdit>> MapEdit::finish() {
  if (refusal_.empty()) rename_references();
  if (!mission_lines_.empty()) {
    std::string lines;
    for (const std::string& line : mission_lines_) lines += (lines.empty() ? "" : "\n") + line;
    add_to_preamble(lines);
  }
  std::vector<TextEdit> out;
  const auto take = [&](const text::WordChanges& changes) {
    if (changes.is_empty()) return;
    std::optional<text::Splice> joined = changes.joined();
    if (!joined) refuse("two changes of this edit are about the same words");
    if (joined) out.push_back({changes.source(), std::move(*joined)});
  };
  take(mission_.words);
  for (const OverlayDocument& document : overlays_) take(document.words);
  if (!refusal_.empty()) return documents::refused("cannot-edit", refusal_);
  return out;
}

}  // namespace

text::Result<std::vector<TextEdit>> edit_map(const MapTexts& texts,
                                             const google::protobuf::RepeatedPtrField<MapChange>& changes,
                                             const std::string& target) {
  MapEdit edit(texts, target);
  for (const MapChange& change : changes) edit.apply(change);
  return edit.finish();
}

text::Result<std::vector<TextEdit>> create_obstacles(const MapTexts& texts, const CreateObstacles& request,
                                                     std::uint32_t seed, bool& is_complete) {
  MapEdit edit(texts, "");
  is_complete = edit.create(request, seed);
  return edit.finish();
}

}  // namespace mlab::console
