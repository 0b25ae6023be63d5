#pragma once

#include <cmath>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace mlab::metrics::testing {

/// What a monitoring system makes of an answer: read by the grammar of the text format 0.0.4, and by the
/// conventions that Prometheus's own checker (`promtool check metrics`) asks for.
class Scrape {
 public:
  explicit Scrape(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) read(line);
    if (!text.empty() && text.back() != '\n') complain("the last line has no end");
    for (const auto& [name, type] : types_) look_at(name, type);
  }

  /// What is wrong with the text, a line for each; empty: nothing.
  const std::string& problems() const { return problems_; }
  /// By name and labels as they are written: `mlab_robots{state="running"}`.
  const std::map<std::string, double>& values() const { return values_; }
  double value(const std::string& series) const {
    const auto found = values_.find(series);
    return found == values_.end() ? std::nan("") : found->second;
  }
  /// Names of the samples, `_bucket` and the like included.
  const std::set<std::string>& names() const { return names_; }
  /// By family: `counter`, `gauge`, `histogram`.
  const std::map<std::string, std::string>& types() const { return types_; }

 private:
  void complain(const std::string& what) { problems_ += what + "\n"; }

  void read(const std::string& line) {
    static const std::regex kHelp("# HELP ([a-zA-Z_:][a-zA-Z0-9_:]*) (\\S.*)");
    static const std::regex kType("# TYPE ([a-zA-Z_:][a-zA-Z0-9_:]*) (counter|gauge|histogram)");
    static const std::regex kSample(
        "([a-zA-Z_:][a-zA-Z0-9_:]*)"
        R"((\{[a-zA-Z_][a-zA-Z0-9_]*="(?:[^"\\\n]|\\["\\n])*"(?:,[a-zA-Z_][a-zA-Z0-9_]*="(?:[^"\\\n]|\\["\\n])*")*,?\})?)"
        " ([-+]?(?:[0-9.]+(?:[eE][-+]?[0-9]+)?|Inf|Nan))");
    std::smatch parts;
    if (std::regex_match(line, parts, kHelp)) {
      if (!helps_.insert(parts[1]).second) complain("a second HELP: " + line);
      family_ = parts[1];
    } else if (std::regex_match(line, parts, kType)) {
      if (!types_.emplace(parts[1], parts[2]).second) complain("a second TYPE: " + line);
      if (parts[1] != family_) complain("no HELP before: " + line);
      family_ = parts[1];
    } else if (std::regex_match(line, parts, kSample)) {
      take(parts[1], parts[2], parts[3]);
    } else {
      complain("no line of the format: " + line);
    }
  }

  void take(const std::string& name, const std::string& labels, const std::string& value) {
    const bool is_histogram = types_[family_] == "histogram";
    const bool is_in_family =
        name == family_ || (is_histogram && (name == family_ + "_bucket" || name == family_ + "_sum" ||
                                             name == family_ + "_count"));
    if (!is_in_family) complain("not below its TYPE: " + name);
    if (!values_.emplace(name + labels, std::strtod(value.c_str(), nullptr)).second)
      complain("a second time: " + name + labels);
    names_.insert(name);
    if (name == family_ + "_bucket")
      buckets_[family_].emplace_back(labels, std::strtod(value.c_str(), nullptr));
  }

  void look_at(const std::string& name, const std::string& type) {
    if (name.ends_with("_total") != (type == "counter"))
      complain("counters, and nothing else, end with _total: " + name);
    for (const char* unit : {"_ms", "_milliseconds", "_minutes", "_kilobytes", "_percent"}) {
      if (name.ends_with(unit)) complain("no base unit: " + name);
    }
    if (type != "histogram") return;
    double before = 0.0;
    for (const auto& [labels, count] : buckets_[name]) {
      if (count < before) complain("buckets do not grow: " + name + labels);
      before = count;
    }
    if (buckets_[name].empty() || buckets_[name].back().first.find("+Inf") == std::string::npos)
      complain("no last bucket: " + name);
    if (before != value(name + "_count")) complain("the last bucket does not hold all: " + name);
  }

  std::string problems_;
  std::string family_;
  std::set<std::string> helps_;
  std::map<std::string, std::string> types_;
  std::map<std::string, double> values_;
  std::set<std::string> names_;
  std::map<std::string, std::vector<std::pair<std::string, double>>> buckets_;
};

}  // namespace mlab::metrics::testing
