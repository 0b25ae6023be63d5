#include <algorithm>
#include <random>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/overview.h"
#include "mlab/console/session_parts.h"
#include "mlab/overlay/picture.h"

namespace mlab::console {
namespace {

// What a Result's error says to a person.
std::optional<std::string> error_of(const text::Result<bool>& result) {
  if (result) return std::nullopt;
  return result.error().message;
}

std::uint32_t any_seed() {
  return std::max(1U, static_cast<std::uint32_t>(std::random_device{}()) & 0x7fffffffU);
}

}  // namespace

Session::Parts::Answered Session::Parts::edit(const std::string& who, const ToServer& message) {
  const auto log_edit = [&](const std::string& what) {
    log_.add(sim_time(), {Log::EDIT, fmt::format("{}: {}", who, clean(what)), 0, "", {}, false});
  };
  const std::string undo_name = documents_.edit_state().undo();
  const std::string redo_name = documents_.edit_state().redo();
  Answered error;
  switch (message.body_case()) {
    case ToServer::kEditText:
      error = error_of(documents_.edit_text(message.edit_text(), now()));
      break;
    case ToServer::kEditMap:
      error = error_of(documents_.edit_map(message.edit_map(), now()));
      if (!error) log_edit(message.edit_map().name());
      break;
    case ToServer::kCreateObstacles: {
      const std::uint32_t seed =
          message.create_obstacles().seed() == 0 ? any_seed() : message.create_obstacles().seed();
      error = error_of(documents_.create_obstacles(message.create_obstacles(), seed, now()));
      if (!error) log_edit(fmt::format("create obstacles with seed {}", seed));
      break;
    }
    case ToServer::kUndo:
      if (!documents_.undo()) return "there is nothing to undo";
      log_edit("undo " + undo_name);
      changes_.project = true;
      break;
    case ToServer::kRedo:
      if (!documents_.redo()) return "there is nothing to do again";
      log_edit("redo " + redo_name);
      changes_.project = true;
      break;
    case ToServer::kNewDocument:
      error = error_of(documents_.create(message.new_document(), now()));
      if (!error) log_edit("new " + message.new_document().path());
      changes_.project = true;  // the mission that is open may be this one
      break;
    case ToServer::kSaveDocuments:
      error = error_of(documents_.save(message.save_documents()));
      changes_.project = true;
      if (!error) log_edit("save");
      break;
    default:
      return "this request is not known here";
  }
  keep_drafts();
  follow_documents();
  return error;
}

// Whatever ends this process after the answer, what it answers is in the file system, or the page says that
// it is not.
void Session::Parts::keep_drafts() {
  documents_.keep_drafts(now());
  tell_not_kept();
}

void Session::Parts::tell_not_kept() {
  std::string why = documents_.not_kept();
  if (why == not_kept_) return;
  not_kept_ = std::move(why);
  changes_.edits = true;
  if (settings_.tell_not_kept) settings_.tell_not_kept(not_kept_);
}

Session::Parts::Answered Session::Parts::open(const std::string& who, const std::string& path) {
  if (auto error = error_of(documents_.open(path, now()))) return error;
  note(who, fmt::format("open {}", clean(path)));
  parameters_.clear();
  from_documents_.reset();
  changes_.project = true;
  follow_documents(Follow::kAnew);
  return std::nullopt;
}

void Session::Parts::follow_documents(Follow how) {
  changes_.documents = changes_.edits = changes_.scene = changes_.status = true;
  for (std::string& notice : documents_.take_notices())
    log_.add(sim_time(), {Log::EDIT, std::move(notice), 0, "", {}, false});
  update_picture();
  const bool same = documents_.mission() == from_documents_ && how == Follow::kGoesOn;
  if (same && (live_ || is_loading_ || !from_documents_)) return;
  if (how == Follow::kAnew || is_loading_ || !live_ || !live_->was_started()) {
    load(seed_, how == Follow::kGoesOn && live_ ? live_->crew() : nullptr);
    return;
  }
  from_documents_ = documents_.mission();
  std::shared_ptr<const mission::Mission> plain = from_documents_;
  std::erase_if(typed_edits_, [&](const std::string& line) {
    text::Diagnostics problems;
    const auto read = mdl::parse_immediate(line, *plain, problems, documents_.load_options());
    if (read && read->edited) {
      plain = read->edited;
      return false;
    }
    log_.add(sim_time(), {Log::WARNING, fmt::format("no longer in force: {}", line), 0, "", {}, true});
    return true;
  });
  change_mission(plain);
}

bool Session::Parts::change_mission(std::shared_ptr<const mission::Mission> plain) {
  plain_ = std::move(plain);
  const std::shared_ptr<const mission::Mission> mission = plain_;
  const std::uint64_t number = ++loading_;
  const auto& known = live_->crew()->programs;
  const bool is_quick = std::ranges::all_of(mission->types, [&](const mission::RobotType& type) {
    return std::ranges::find(known, type.program, &robot::RobotProgram::name) != known.end();
  });
  const auto change = [this, number](const std::shared_ptr<const fleet::Crew>& crew,
                                     const text::Diagnostics& problems) {
    if (number != loading_ || !live_) return;
    if (!crew) {
      report_problems(problems);
      return;
    }
    live_->edit(crew);
    breakpoints_.change(&live_->run());
    ++plan_revision_;
    ++version_;
    has_nothing_to_do_ = false;
    changes_.roster = changes_.starts = changes_.plan = changes_.status = changes_.questions =
        changes_.scene = true;
  };
  if (is_quick) {
    text::Diagnostics problems;
    change(fleet::make_crew(mission, program_sources(), problems, live_->crew().get()), problems);
    return true;
  }
  // Something has to be built, perhaps compiled: the run goes on meanwhile as it was.
  workshop_->start([this, number, mission, before = live_->crew(), sources = program_sources(),
                    files = trial_files_, change] {
    if (number != loading_) return;
    const auto problems = std::make_shared<text::Diagnostics>();
    const auto crew = fleet::make_crew(mission, sources, *problems, before.get());
    inbox_.post([change, crew, problems] { change(crew, *problems); });
  });
  return false;
}

// ---- parameters of robots

Session::Parts::Answered Session::Parts::set_parameter(const std::string& who, const SetParameter& set) {
  if (!live_) return "there is no mission that could run";
  std::vector<std::uint32_t> robots(set.robots().begin(), set.robots().end());
  if (robots.empty()) return "no robot is named";
  std::vector<std::string> before;
  for (const std::uint32_t id : robots) {
    const fleet::FleetRobot* robot = live_->run().fleet().find({id});
    if (robot == nullptr) return fmt::format("there is no robot {}", id);
    const flow::Port* port =
        robot->workings().program ? robot->workings().program->find(set.port()) : nullptr;
    if (port == nullptr) return fmt::format("the program of robot {} has no `{}`", id, clean(set.port()));
    before.push_back(flow::Program::print(robot->workings().frame, *port));
  }
  const std::string& port = set.port();
  const std::vector<std::string> after(robots.size(), set.value());
  if (auto error = apply_parameters(robots, port, after)) {
    apply_parameters(robots, port, before);
    return error;
  }
  const std::string whose =
      robots.size() == 1 ? fmt::format("robot {}", robots[0]) : fmt::format("{} robots", robots.size());
  EditLog::Edit edit;
  edit.name = fmt::format("{} of {}", clean(port), whose);
  edit.undo = [this, robots, port, before] { apply_parameters(robots, port, before); };
  edit.redo = [this, robots, port, after] { apply_parameters(robots, port, after); };
  documents_.add_edit(std::move(edit), now());
  changes_.edits = true;
  log_.add(sim_time(), {Log::EDIT,
                        fmt::format("{}: {} = {} for {}", who, clean(port), clean(set.value()), whose),
                        robots.size() == 1 ? robots[0] : 0,
                        "",
                        {},
                        false});
  return std::nullopt;
}

Session::Parts::Answered Session::Parts::apply_parameters(const std::vector<std::uint32_t>& robots,
                                                          const std::string& port,
                                                          const std::vector<std::string>& values) {
  ++version_;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (live_) {
      if (auto error = live_->run().set_parameter({robots[i]}, port, values[i])) return error;
    }
    parameters_[robots[i]][port] = values[i];
  }
  return std::nullopt;
}

// ---- the background picture

void Session::Parts::update_picture() {
  const std::uint64_t revision = documents_.scene().revision();
  if (revision == picture_revision_) return;
  Picture picture;
  const auto& planned = documents_.map()->map_picture;
  const auto name = planned ? project_.name_of(planned->file) : std::nullopt;
  if (name) {
    if (auto bytes = project_.read(*name)) {
      overlay::ShownPicture shown = overlay::shown_picture(std::move(*bytes));
      picture.content_type = std::move(shown.content_type);
      if (!picture.content_type.empty())
        picture.bytes = std::make_shared<const std::string>(std::move(shown.bytes));
    }
  }
  const std::scoped_lock lock(picture_mutex_);
  picture_revision_ = revision;
  picture_ = std::move(picture);
}

}  // namespace mlab::console
