#include "mlab/designer/trial/write_back.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/trial/live_paths.h"
#include "mlab/lang/cdl/lower/lower.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

std::unexpected<text::Diagnostic> not_written(std::string message) {
  return std::unexpected(
      text::Diagnostic{text::Severity::kError, "cannot-write-back", std::move(message), {}, {}, {}, {}});
}

/// `movement.Noise.gains[2]`
struct PortName {
  std::string node;
  std::string input;
  std::optional<std::uint32_t> index;
};

PortName parts_of_port(std::string_view path) {
  PortName out;
  if (path.ends_with(']')) {
    const std::size_t open = path.rfind('[');
    std::uint32_t index = 0;
    const char* const end = path.data() + path.size() - 1;
    if (open != std::string_view::npos && std::from_chars(path.data() + open + 1, end, index).ptr == end) {
      out.index = index;
      path = path.substr(0, open);
    }
  }
  const std::size_t dot = path.rfind('.');
  out.node = dot == std::string_view::npos ? "" : path.substr(0, dot);
  out.input = dot == std::string_view::npos ? path : path.substr(dot + 1);
  return out;
}

/// What a port stands for in the network.
struct PortSource {
  bool is_known = false;
  const flow::Source* source = nullptr;  ///< null: a default that nobody wrote
};

PortSource find_written(const flow::Network& network, const std::string& port) {
  for (const flow::Parameter& parameter : network.parameters) {
    const bool is_it = parameter.name == port ||
                       std::ranges::find(parameter.other_names, port) != parameter.other_names.end();
    if (is_it) return {true, &parameter.initial};
  }
  const PortName name = parts_of_port(port);
  for (const flow::Node& node : network.nodes) {
    if (node.name != name.node) continue;
    std::uint32_t at = 0;
    for (const flow::Link& link : node.links) {
      if (link.input != name.input) continue;
      if (at++ == name.index.value_or(0)) return {true, &link.source};
    }
    return {true, nullptr};
  }
  return {};
}

bool is_number_text(std::string_view text) {
  double number = 0.0;
  return std::from_chars(text.data(), text.data() + text.size(), number).ec == std::errc{};
}

// The value in the words of what stood there: with a unit where one was said, in quotes where there were
// some.
std::string in_words_of(std::string_view before, const std::string& value, const std::string& unit) {
  if (before.starts_with('"')) return '"' + value + '"';
  const bool has_unit =
      is_number_text(before) && !before.empty() &&
      (std::isalpha(static_cast<unsigned char>(before.back())) != 0 || before.ends_with('%'));
  const bool is_bare =
      is_number_text(value) && !value.empty() && std::isalpha(static_cast<unsigned char>(value.back())) == 0;
  return has_unit && is_bare && !unit.empty() ? value + ' ' + unit : value;
}

// The last two parts of a path: enough for a person.
std::string short_name(const std::string& port) {
  const std::size_t last = port.rfind('.');
  if (last == std::string::npos || last == 0) return port;
  const std::size_t before = port.rfind('.', last - 1);
  return before == std::string::npos ? port : port.substr(before + 1);
}

/// One way of doing it, tried in turn for the robots that run.
class BackWriter {
 public:
  BackWriter(const std::shared_ptr<const Model>& model, const cdl::Environment& environment,
             const TrialConfiguration& tried)
      : model_(model), environment_(environment), tried_(tried), completed_(tried.source, environment) {}

  text::Result<Edited> write(const std::string& port, const std::string& value) {
    for (const auto& [name, count] : tried_.robots) {
      const auto robot = completed_.configuration().robots.find(name);
      if (robot == completed_.configuration().robots.end()) continue;
      text::Diagnostics sink;
      cdl::EarlierFindings said;
      const cdl::LoweredRobot lowered =
          cdl::lower(completed_.configuration(), *robot->second, completed_.library(), sink, said);
      if (sink.has_errors()) return not_written("the text has errors: mend them first");
      const PortSource written = find_written(lowered.network, port);
      if (!written.is_known) continue;
      if (written.source == nullptr) return write_default(name, port, value);
      if (written.source->kind != flow::Source::Kind::kConstant)
        return not_written(fmt::format("`{}` is driven by a wire", text::shown(port, 200)));
      text::Diagnostics unsaid;
      const auto program = cdl::build(lowered, completed_.library(), unsaid, said);
      const flow::Port* known = program ? program->find(port) : nullptr;
      const std::string unit = known == nullptr           ? ""
                               : known->edge_unit.empty() ? known->unit
                                                          : known->edge_unit;
      return write_over(*written.source, port, value, unit);
    }
    return not_written(fmt::format("nothing that runs has `{}` as a constant", text::shown(port, 200)));
  }

 private:
  text::Result<Edited> write_over(const flow::Source& source, const std::string& port,
                                  const std::string& value, const std::string& unit) {
    const text::SourcePtr& where = source.place.source;
    if (!where || where->name() != completed_.source()->name()) {
      return not_written(fmt::format("`{}` stands in {}: make your own copy of that component first",
                                     text::shown(port, 200), where ? where->name() : "no text"));
    }
    const auto before = [&](std::uint32_t byte) {
      return place_before_trial(model_->text(), completed_.text(), byte);
    };
    const text::Span span{before(source.place.span.begin), before(source.place.span.end)};
    const std::string_view words = model_->text().substr(span.begin, span.end - span.begin);
    if (words != where->text(source.place.span) || words.empty())
      return not_written("this value was assumed for trying: it stands nowhere in the text");
    if (words.starts_with('"') && value.find_first_of("\"\n\r") != std::string::npos)
      return not_written("a text in a configuration can't hold `\"` or the end of a line");
    std::string text(model_->text());
    text.replace(span.begin, span.end - span.begin, in_words_of(words, value, unit));
    return checked({std::move(text), fmt::format("write back {} = {}", short_name(port), value)});
  }

  // Nobody said it: it is said now, where the node is drawn.
  text::Result<Edited> write_default(const std::string& robot, const std::string& port,
                                     const std::string& value) {
    const PortName name = parts_of_port(port);
    Edit edit;
    visit_instances(completed_, robot, [&](const OwnerGraph& graph, const std::string& path) {
      if (edit.changes_size() > 0 || model_->graph(graph.name) == nullptr) return;
      for (const GraphPage& page : graph.pages) {
        for (const GraphNode& node : page.nodes) {
          const bool is_it = node.kind == GraphNode::Kind::kCall && joined_path(path, node.path) == name.node;
          if (!is_it || edit.changes_size() > 0) continue;
          SetValue& set = *edit.add_changes()->mutable_set_value();
          set.set_page(page.path);
          set.set_node(node.name);
          set.set_port(name.input);
          set.set_value(value);
        }
      }
    });
    if (edit.changes_size() == 0)
      return not_written(fmt::format("`{}` belongs to a component of the library: make your own copy first",
                                     text::shown(port, 200)));
    text::Result<Edited> out = edited(model_, environment_, edit);
    if (!out) return out;
    out->name = fmt::format("write back {} = {}", short_name(port), value);
    return checked(std::move(*out));
  }

  text::Result<Edited> checked(Edited done) const {
    const auto errors_of = [&](const std::string& text) {
      Model model(std::make_shared<const text::Source>(model_->source()->name(), text), environment_);
      model.check();
      std::vector<std::string> out;
      for (const text::Diagnostic& d : model.problems().items()) {
        if (d.severity == text::Severity::kError) out.push_back(d.message);
      }
      return out;
    };
    const std::vector<std::string> after = errors_of(done.text);
    if (!after.empty() && errors_of(std::string(model_->text())).empty()) return not_written(after.front());
    return done;
  }

  const std::shared_ptr<const Model>& model_;
  const cdl::Environment& environment_;
  const TrialConfiguration& tried_;
  const Model completed_;
};

}  // namespace

text::Result<Edited> written_back(const std::shared_ptr<const Model>& model,
                                  const cdl::Environment& environment, const TrialConfiguration& tried,
                                  const std::string& port, const std::string& value) {
  return BackWriter(model, environment, tried).write(port, value);
}

}  // namespace mlab::designer
