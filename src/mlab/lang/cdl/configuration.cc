#include "mlab/lang/cdl/configuration.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/lang/cdl/formula/formula.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cnl/check.h"
#include "mlab/lang/cnl/load.h"
#include "mlab/text/shown.h"

namespace mlab::cdl {
namespace {

namespace fs = std::filesystem;

class Loader {
 public:
  Loader(const Environment& environment, text::Diagnostics& sink)
      : files_(environment.files == nullptr ? text::files_on_disk() : *environment.files), sink_(sink) {
    out_.built_in = environment.built_in;
  }

  Configuration run(std::shared_ptr<const Tree> tree) {
    out_.source = tree->source;
    const std::string path = tree->source ? normal(tree->source->name()) : "";
    seen_.insert(path);
    open_.push_back(path);
    add(std::move(tree), path);
    for (const auto& one : out_.built_in) declare(*one, false);
    for (const auto& one : out_.trees) declare(*one, true);
    return std::move(out_);
  }

 private:
  static std::string normal(const std::string& path) {
    std::error_code failure;
    const fs::path canonical = fs::weakly_canonical(path, failure);
    return failure ? path : canonical.string();
  }

  void add(std::shared_ptr<const Tree> tree, const std::string& path) {
    const Tree& added = *out_.trees.emplace_back(std::move(tree));
    const std::string from = added.source ? added.source->name() : path;
    for (const Item& item : added.items) {
      if (const auto* use = std::get_if<Use>(&item)) follow(*use, from);
    }
  }

  void follow(const Use& use, const std::string& from) {
    const Word& name = use.path;
    if (name.text.empty() || name.text.find('\0') != std::string::npos) {
      sink_.error("cannot-read", name.place, "this is not the name of a file");
      return;
    }
    // What a file holds is told by its name alone: nothing else is ever read as code.
    if (!name.text.ends_with(".cdl") && !name.text.ends_with(".cnl")) {
      sink_.error(
          "unknown-language", name.place,
          fmt::format("`{}` is neither a configuration (.cdl) nor CNL (.cnl)", text::shown(name.text)));
      return;
    }
    const std::string path = (fs::path(from).parent_path() / name.text).string();
    const std::string key = normal(path);
    if (std::ranges::find(open_, key) != open_.end()) {
      sink_.error("use-cycle", name.place, fmt::format("`{}` uses itself", text::shown(name.text)));
      return;
    }
    if (seen_.contains(key)) return;
    if (open_.size() >= kMaxUseDepth) {
      sink_.error("use-too-deep", name.place, fmt::format("more than {} files use each other", kMaxUseDepth));
      return;
    }
    const auto source = files_.read(path);
    if (!source) {
      text::Diagnostic failure = source.error();
      failure.place = name.place;
      sink_.report(std::move(failure));
      return;
    }
    seen_.insert(key);
    out_.files.push_back(path);
    open_.push_back(key);
    read(*source, name);
    open_.pop_back();
  }

  void read(const text::SourcePtr& source, const Word& name) {
    if (name.text.ends_with(".cnl")) {
      const auto tree = std::make_shared<const cnl::Tree>(cnl::load(source, sink_, &out_.files, files_));
      cnl::check_declarations(*tree, sink_);
      out_.procedures.push_back(tree);
    } else {
      add(std::make_shared<const Tree>(parse(source, sink_)), source->name());
    }
  }

  // Own declarations come later, and hide those of the library.
  template <class Kind>
  void declare(const Kind& what, Configuration::Table<Kind>& table, bool is_own, const char* kind) {
    if (is_own) {
      const auto [it, is_new] =
          declared_.try_emplace(fmt::format("{} {}", kind, what.name.text), what.name.place);
      if (!is_new) {
        sink_
            .error("duplicate-declaration", what.name.place,
                   fmt::format("{} `{}` is declared twice", kind, what.name.text))
            .notes.push_back({"the first is here", it->second});
        return;
      }
    }
    table[what.name.text] = &what;
  }

  void declare(const Tree& tree, bool is_own) {
    for (const Item& item : tree.items) {
      if (const auto* assemblage = std::get_if<Assemblage>(&item)) {
        declare(*assemblage, out_.assemblages, is_own, "assemblage");
        if (!is_own) {
          out_.built_in_assemblages[assemblage->name.text] = assemblage;
          out_.built_in_sources.insert(assemblage->name.place.source.get());
        }
        if (is_own) out_.own_assemblages.push_back(assemblage);
      } else if (const auto* binding = std::get_if<Binding>(&item)) {
        declare(*binding, out_.bindings, is_own, "binding point");
      } else if (const auto* robot_class = std::get_if<RobotClass>(&item)) {
        declare(*robot_class, out_.classes, is_own, "class");
        if (is_own) out_.own_classes.push_back(robot_class);
      } else if (const auto* robot = std::get_if<Robot>(&item)) {
        declare(*robot, out_.robots, is_own, "robot");
        if (is_own) out_.own_robots.push_back(robot);
      } else if (const auto* op = std::get_if<SocietyOperator>(&item)) {
        declare(*op, out_.operators, is_own, "operator");
        if (is_own) out_.own_operators.push_back(op);
      } else if (const auto* society = std::get_if<Society>(&item)) {
        declare(*society, out_.societies, is_own, "society");
        if (is_own) out_.own_societies.push_back(society);
      } else if (const auto* architecture = std::get_if<Architecture>(&item)) {
        if (is_own) choose(architecture->name);
      }
    }
  }

  // AuRA goes to CNL and programs, UGV to SAUSAGES plans.
  void choose(const Word& architecture) {
    static constexpr std::array<std::string_view, 2> kKnown = {"AuRA", "UGV"};
    if (std::ranges::find(kKnown, architecture.text) == kKnown.end()) {
      sink_
          .error("unknown-architecture", architecture.place,
                 fmt::format("unknown architecture `{}`", architecture.text))
          .hints = {"there are AuRA, for robots that run the configuration, and UGV, for SAUSAGES plans"};
    } else if (out_.architecture.empty()) {
      out_.architecture = architecture.text;
    }
  }

  const text::Files& files_;
  text::Diagnostics& sink_;
  Configuration out_;
  std::set<std::string> seen_;
  std::vector<std::string> open_;
  std::map<std::string, text::Place> declared_;
};

bool same_letters(std::string_view a, std::string_view b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(a, b, {}, small, small);
}

/// Walks through societies; one that is in itself is entered once.
class SocietyWalk {
 public:
  explicit SocietyWalk(const Configuration& configuration) : configuration_(configuration) {}

  void enter(const Society& society, int count = 1) {
    if (std::ranges::find(open_, &society) != open_.end()) return;
    if (open_.size() == kMaxSocietyDepth) {
      is_too_large = true;
      return;
    }
    open_.push_back(&society);
    enter(society.what, count);
    open_.pop_back();
  }

  const Robot* wanted = nullptr;
  std::vector<const SocietyOperator*> found_operators;  // of the first place where `wanted` stands
  bool is_found = false;
  std::vector<std::pair<const Robot*, int>> robots;
  bool is_too_large = false;  // not all of it was entered

 private:
  void enter(const SocietyMember& member, int count) {
    constexpr int kMostSteps = 100'000;  // societies of societies of societies grow fast
    if (++steps_ > kMostSteps) {
      is_too_large = true;
      return;
    }
    const auto op = configuration_.operators.find(member.by.text);
    const bool has_operator = op != configuration_.operators.end();
    if (has_operator) operators_.push_back(op->second);
    if (member.kind == SocietyMember::Kind::kCaste) {
      for (const SocietyMember& one : member.members) enter(one, count);
    } else {
      is_too_large = is_too_large || count > kMostRobotsOfASociety / member.count;
      enter_named(member.name.text, std::min(count, kMostRobotsOfASociety / member.count) * member.count);
    }
    if (has_operator) operators_.pop_back();
  }

  void enter_named(const std::string& name, int count) {
    if (const auto robot = configuration_.robots.find(name); robot != configuration_.robots.end()) {
      is_too_large = is_too_large || count > kMostRobotsOfASociety - total_;
      if (!is_too_large) {
        robots.emplace_back(robot->second, count);
        total_ += count;
      }
      if (robot->second != wanted || is_found) return;
      is_found = true;
      found_operators = operators_;
    } else if (const auto society = configuration_.societies.find(name);
               society != configuration_.societies.end()) {
      enter(*society->second, count);
    }
  }

  const Configuration& configuration_;
  std::vector<const Society*> open_;
  std::vector<const SocietyOperator*> operators_;
  int steps_ = 0;
  int total_ = 0;
};

}  // namespace

Configuration configuration_of(std::shared_ptr<const Tree> tree, const Environment& environment,
                               text::Diagnostics& sink) {
  return Loader(environment, sink).run(std::move(tree));
}

const Assemblage* Configuration::assemblage_named(const Word& name) const {
  const bool is_built_in = name.place.source != nullptr && built_in_sources.contains(name.place.source.get());
  const Table<Assemblage>& table = is_built_in ? built_in_assemblages : assemblages;
  const auto found = table.find(name.text);
  return found == table.end() ? nullptr : found->second;
}

Configuration load(const text::SourcePtr& source, const Environment& environment, text::Diagnostics& sink) {
  const bool is_formula = source->name().ends_with(".formula") || looks_like_formula(source->text());
  Tree tree = is_formula ? parse_formula(source, sink) : parse(source, sink);
  return configuration_of(std::make_shared<const Tree>(std::move(tree)), environment, sink);
}

const Robot* robot_meant(const Configuration& configuration, std::string_view wanted,
                         std::string_view type_name, const text::Place& place, text::Diagnostics& sink) {
  const std::vector<const Robot*>& robots = configuration.own_robots;
  const std::string file = configuration.source ? configuration.source->name() : "";
  std::vector<std::string> names;
  for (const Robot* robot : robots) names.push_back(robot->name.text);
  if (!wanted.empty()) {
    for (const Robot* robot : robots) {
      if (robot->name.text == wanted) return robot;
    }
    text::Diagnostic& d =
        sink.error("unknown-robot", place, fmt::format("`{}` has no robot `{}`", file, text::shown(wanted)));
    const std::string nearest = text::nearest_name(wanted, names);
    if (configuration.societies.contains(wanted))
      d.hints.push_back(fmt::format("`{}` is a society: name one of its robots", wanted));
    else if (!nearest.empty())
      d.hints.push_back(fmt::format("did you mean `{}`?", nearest));
    return nullptr;
  }
  for (const Robot* robot : robots) {
    if (same_letters(robot->name.text, type_name)) return robot;
  }
  if (robots.size() == 1) return robots.front();
  if (robots.empty()) {
    sink.error("no-robot", place, fmt::format("`{}` has no robot in it", file)).hints = {
        "`robot NAME is CLASS { movement = ...; }` makes one of its assemblages"};
  } else {
    sink.error("several-robots", place,
               fmt::format("`{}` has several robots: {}", file, fmt::join(names, ", ")))
        .hints = {fmt::format("name one: `{}#{}`", fs::path(file).filename().string(), names.front())};
  }
  return nullptr;
}

const Society* society_meant(const Configuration& configuration, std::string_view wanted,
                             const text::Place& place, text::Diagnostics& sink) {
  const auto is_wanted = [&](const auto* one) { return one->name.text == wanted; };
  const auto& societies = configuration.own_societies;
  const auto society = std::ranges::find_if(societies, is_wanted);
  const bool is_society = society != societies.end();
  const std::string file = configuration.source ? configuration.source->name() : "";
  if (std::ranges::any_of(configuration.own_robots, is_wanted)) {
    if (is_society)
      sink.warning("ambiguous-program", place,
                   fmt::format("`{}` has a robot and a society `{}`: the robot is meant", file, wanted))
          .notes.push_back({"the society is here", (*society)->name.place});
    return nullptr;
  }
  if (is_society) return *society;
  std::vector<std::string> names;
  for (const Robot* robot : configuration.own_robots) names.push_back(robot->name.text);
  for (const Society* one : societies) names.push_back(one->name.text);
  text::Diagnostic& d = sink.error(
      "unknown-robot", place, fmt::format("`{}` has no robot or society `{}`", file, text::shown(wanted)));
  const std::string nearest = text::nearest_name(wanted, names);
  if (!nearest.empty()) d.hints.push_back(fmt::format("did you mean `{}`?", nearest));
  return nullptr;
}

std::vector<const SocietyOperator*> operators_of(const Configuration& configuration, const Robot& robot) {
  SocietyWalk walk(configuration);
  walk.wanted = &robot;
  for (const Society* society : configuration.own_societies) {
    if (!walk.is_found) walk.enter(*society);
  }
  return walk.found_operators;
}

std::optional<std::vector<std::pair<const Robot*, int>>> members_of(const Configuration& configuration,
                                                                    const Society& society) {
  SocietyWalk walk(configuration);
  walk.enter(society);
  if (walk.is_too_large) return std::nullopt;
  return walk.robots;
}

}  // namespace mlab::cdl
