#include "mlab/study/study_file.h"

#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/study/toml_text.h"
#include "mlab/text/shown.h"

namespace mlab::study {
namespace {

// Where a line and a column begin, both from 1, columns of characters.
std::uint32_t offset_of(const text::Source& source, toml::source_position position) {
  if (position.line == 0) return 0;
  const std::string_view line = source.line(position.line);
  std::size_t at = 0;
  for (toml::source_index column = 1; column < position.column && at < line.size(); ++column) {
    ++at;
    while (at < line.size() && (static_cast<unsigned char>(line[at]) & 0xc0U) == 0x80U) ++at;
  }
  const char* const end = source.text().data() + source.text().size();
  const char* const found = line.data() == nullptr ? end : line.data() + at;
  return static_cast<std::uint32_t>(found - source.text().data());
}

class StudyReader {
 public:
  StudyReader(text::SourcePtr source, Definition& definition, text::Diagnostics& sink)
      : source_(std::move(source)),
        folder_(std::filesystem::path(source_->name()).parent_path()),
        definition_(definition),
        sink_(sink) {}

  void read(const toml::table& all) {
    for (const auto& [key, node] : all) {
      const auto known =
          std::ranges::find(fields(), std::string_view(key.str()), [](const Field& f) { return f.name; });
      if (key.str() == "set") {
        read_values(node);
      } else if (known != fields().end()) {
        read_field(*known, node);
      } else {
        tell_unknown(key);
      }
    }
  }

  text::Place place_of(const toml::source_region& region) const {
    const std::uint32_t begin = offset_of(*source_, region.begin);
    return {source_, {begin, std::max(begin, offset_of(*source_, region.end))}};
  }

 private:
  void tell_unknown(const toml::key& key) {
    std::vector<std::string> names = {"set"};
    for (const Field& field : fields()) names.emplace_back(field.name);
    text::Diagnostic& error = sink_.error("unknown-key", place_of(key.source()),
                                          fmt::format("a study has no `{}`", text::shown(key.str())));
    const std::string nearest = text::nearest_name(key.str(), names);
    if (!nearest.empty()) error.hints.push_back(fmt::format("did you mean `{}`?", nearest));
  }

  // A text, a number or a time as it would stand on the command line.
  std::optional<Written> scalar(const toml::node& node) {
    Written out{{}, place_of(node.source())};
    const std::string_view raw = source_->text(out.place.span);
    if (const auto* text = node.as_string()) {
      out.text = text->get();
      // Places within it count where it stands there as it is.
      if (raw.size() == out.text.size() + 2 && raw.substr(1, out.text.size()) == out.text) {
        ++out.place.span.begin;
        --out.place.span.end;
      }
    } else if (const auto* whole = node.as_integer()) {
      out.text = fmt::format("{}", whole->get());
    } else if (const auto* number = node.as_floating_point()) {
      out.text = shortest(number->get());
    } else if (const auto* flag = node.as_boolean()) {
      out.text = flag->get() ? "1" : "0";
    } else if (node.is_date() || node.is_time() || node.is_date_time()) {
      out.text = raw;
    } else {
      sink_.error("expected", out.place, "expected a text or a number");
      return std::nullopt;
    }
    return out;
  }

  void read_field(const Field& field, const toml::node& node) {
    if (const toml::array* all = node.as_array(); all != nullptr && field.is_repeated) {
      for (const toml::node& one : *all) read_field(field, one);
      return;
    }
    std::optional<Written> value = scalar(node);
    if (!value) return;
    const bool is_no_file = field.name == "recordings" && value->text == kNoRecordings;
    if (field.is_file && !is_no_file && !value->empty())
      value->text = (folder_ / value->text).lexically_normal().string();
    if (auto problem = take(definition_, field.name, *value)) sink_.report(std::move(*problem));
  }

  void read_values(const toml::node& node) {
    const toml::table* all = node.as_table();
    if (all == nullptr) {
      sink_.error("expected", place_of(node.source()), "expected a table of values: [set]");
      return;
    }
    // In the order in which they stand there: the first one's values change last.
    std::vector<std::pair<Written, const toml::node*>> ordered;
    for (const auto& [key, value] : *all)
      ordered.emplace_back(Written{std::string(key.str()), place_of(key.source())}, &value);
    std::ranges::sort(ordered, {}, [](const auto& one) { return one.first.place.span.begin; });
    for (const auto& [name, value] : ordered) read_dimension(name, *value);
  }

  void read_dimension(const Written& name, const toml::node& node) {
    const toml::array* list = node.as_array();
    if (list != nullptr && !list->empty()) {
      Dimension out{name, {}, 0.0, 0.0};
      for (const toml::node& one : *list) {
        if (auto value = scalar(one)) out.values.push_back(std::move(*value));
      }
      definition_.dimensions.push_back(std::move(out));
      return;
    }
    const std::optional<Written> value = scalar(node);
    if (!value) return;
    auto dimension = dimension_of(name, *value);
    if (dimension)
      definition_.dimensions.push_back(std::move(*dimension));
    else
      sink_.report(std::move(dimension.error()));
  }

  text::SourcePtr source_;
  std::filesystem::path folder_;
  Definition& definition_;
  text::Diagnostics& sink_;
};

}  // namespace

bool is_study_file(const std::string& path) {
  return std::filesystem::path(path).extension() == ".toml";
}

bool read_study(const text::SourcePtr& source, Definition& definition, text::Diagnostics& sink) {
  const std::size_t before = sink.error_count();
  StudyReader reader(source, definition, sink);
  if (const std::optional<Unfit> unfit = unfit_place(source->text())) {
    std::size_t end = unfit->at + 1;
    while (end < source->text().size() && (static_cast<unsigned char>(source->text()[end]) & 0xc0U) == 0x80U)
      ++end;
    sink.error("no-toml", {source, {static_cast<std::uint32_t>(unfit->at), static_cast<std::uint32_t>(end)}},
               fmt::format("`{}` can't stand here: {}",
                           text::shown(source->text().substr(unfit->at, end - unfit->at)), unfit->why));
    return false;
  }
  toml::parse_result parsed = toml::parse(source->text(), std::string_view(source->name()));
  if (!parsed) {
    sink.error("no-toml", reader.place_of(parsed.error().source()),
               std::string(parsed.error().description()));
    return false;
  }
  reader.read(parsed.table());
  return sink.error_count() == before;
}

}  // namespace mlab::study
