#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/mdl/commands.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/names.h"
#include "mlab/lang/mdl/options.h"
#include "mlab/lang/mdl/parser.h"
#include "mlab/lang/mdl/plan_check.h"
#include "mlab/lang/mdl/preamble.h"

namespace mlab::mdl {
namespace {

// Reads a typed line into a copy of the mission, so that units and obstacles can be added to it.
class TypedLine {
 public:
  TypedLine(const Tree& tree, const mission::Mission& mission, text::Diagnostics& diagnostics,
            const LoadOptions& options)
      : tree_(tree),
        diagnostics_(diagnostics),
        options_(options),
        edited_(std::make_shared<mission::Mission>(mission)),
        places_(edited_->overlay),
        roster_(*edited_, tree.source, tree.damage, diagnostics),
        reader_({*edited_, places_, roster_, tree.damage, {}}, tree.source, diagnostics) {}

  Immediate run() {
    for (const Statement& statement : tree_.typed) read(statement);
    std::ranges::sort(edited_->robots, {}, &mission::Robot::id);
    check_commands_of_one_step(out_.commands, *edited_, diagnostics_);
    if (has_edits_) {
      edited_->typed.emplace_back(tree_.source->text());
      out_.edited = std::move(edited_);
    }
    return std::move(out_);
  }

 private:
  void read(const Statement& statement) {
    if (const auto* unit = std::get_if<statement::UnitDefinition>(&statement.what)) {
      roster_.define_unit(*unit);
      has_edits_ = true;
    } else if (const auto* obstacle = std::get_if<statement::Obstacle>(&statement.what)) {
      add_obstacle(*obstacle);
    } else if (std::holds_alternative<statement::CreateObstacles>(statement.what)) {
      create_obstacles_anew(statement.span);
    } else if (std::holds_alternative<statement::InjectTrack>(statement.what)) {
      diagnostics_.warning("no-effect", {tree_.source, statement.span}, "INJECTTRACK has no effect");
    } else if (auto command = reader_.read(statement)) {
      apply_set(*command, edited_->options);
      has_edits_ |= std::holds_alternative<mission::SetNumber>(*command);
      out_.commands.push_back(std::move(*command));
    }
  }

  void add_obstacle(const statement::Obstacle& obstacle) {
    const auto read = read_obstacle(obstacle, edited_->overlay.origin, tree_.source, diagnostics_);
    if (!read) return;
    edited_->overlay.obstacles.push_back(*read);
    has_edits_ = out_.changes_obstacles = true;
  }

  void create_obstacles_anew(text::Span span) {
    edited_->overlay.obstacles = create_obstacles(edited_->options, edited_->overlay.mission_area(),
                                                  options_.seed, {tree_.source, span}, diagnostics_);
    has_edits_ = out_.changes_obstacles = true;
  }

  const Tree& tree_;
  text::Diagnostics& diagnostics_;
  const LoadOptions& options_;
  std::shared_ptr<mission::Mission> edited_;
  PlaceIndex places_;
  Roster roster_;
  CommandReader reader_;
  Immediate out_;
  bool has_edits_ = false;
};

}  // namespace

std::optional<Immediate> parse_immediate(const std::string& line, const mission::Mission& mission,
                                         text::Diagnostics& diagnostics, const LoadOptions& options) {
  const std::size_t errors = diagnostics.error_count();
  const auto source = std::make_shared<const text::Source>("typed command", line);
  const Tree tree = Parser(source, diagnostics).typed_line();
  if (diagnostics.error_count() > errors) return std::nullopt;
  Immediate out = TypedLine(tree, mission, diagnostics, options).run();
  if (diagnostics.error_count() > errors) return std::nullopt;
  return out;
}

}  // namespace mlab::mdl
