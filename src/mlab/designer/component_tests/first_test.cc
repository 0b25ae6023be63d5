#include "mlab/designer/component_tests/first_test.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <variant>

#include <fmt/core.h>

#include "mlab/designer/trial/trial.h"
#include "mlab/lang/cdl/lower/tests.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

std::unexpected<text::Diagnostic> no_test(std::string why) {
  return std::unexpected(
      text::Diagnostic{text::Severity::kError, "cannot-test", std::move(why), {}, {}, {}, {}});
}

// What stands for a parameter that has to be given; empty: nobody can know.
std::string argument_for(const cdl::Parameter& parameter) {
  static const std::map<std::string, std::string, std::less<>> kOfTests = {
      {"Point", "[10 m, 0 m]"}, {"Vector", "DetectGoal([10 m, 0 m])"}, {"text", "\"a\""}};
  const auto known = kOfTests.find(parameter.type.text);
  return known != kOfTests.end() ? known->second : stand_in(parameter);
}

// What an assemblage is likely to do: be in its first state, or give something.
std::string expectation_of(const Model& model, const cdl::Assemblage& assemblage) {
  if (assemblage.body) {
    if (const auto* sequence = std::get_if<cdl::Sequence>(&assemblage.body->what)) {
      const auto start = std::ranges::find_if(sequence->states, &cdl::State::is_start);
      if (start != sequence->states.end()) return "state " + start->name.text;
    }
  }
  const std::string type = model.components().types().result_of(assemblage).name();
  if (type == "Vector") return "length(it) > 0";
  if (type == "bool") return "it";
  if (type == "double" || type == "int") return "it >= 0";
  return "no action Halt";
}

std::string free_test_name(const Model& model, const std::string& wanted) {
  const auto tests = cdl::tests_of(model.tree());
  const auto is_taken = [&](const std::string& name) {
    return std::ranges::any_of(tests, [&](const cdl::Test* test) { return test->name.text == name; });
  };
  std::string out = wanted;
  for (int n = 2; is_taken(out); ++n) out = fmt::format("{} {}", wanted, n);
  return out;
}

}  // namespace

text::Result<std::string> first_test_of(const Model& model, const std::string& component) {
  const cdl::Assemblage* assemblage = nullptr;
  for (const cdl::Item& item : model.tree().items) {
    const auto* one = std::get_if<cdl::Assemblage>(&item);
    const bool is_it = one != nullptr && (component.empty() || one->name.text == component);
    if (is_it && assemblage == nullptr) assemblage = one;
  }
  if (assemblage == nullptr)
    return no_test(component.empty()
                       ? "there is no assemblage in it that could be tested"
                       : fmt::format("there is no assemblage `{}` in it", text::shown(component)));
  std::string arguments;
  for (const cdl::Parameter& parameter : assemblage->parameters) {
    if (parameter.initial) continue;
    const std::string value = argument_for(parameter);
    if (value.empty())
      return no_test(fmt::format("nothing can be assumed for the parameter `{}`: write the test by hand",
                                 text::shown(parameter.name.text)));
    arguments += fmt::format("{}{} = {}", arguments.empty() ? "" : ", ", parameter.name.text, value);
  }
  return fmt::format(
      "test \"{}\" of {}({}) {{\n  given obstacle(at = [6 m, 1 m], radius = 0.5 m);\n  expect {};\n}}\n",
      free_test_name(model, assemblage->name.text + " near an obstacle"), assemblage->name.text, arguments,
      expectation_of(model, *assemblage));
}

}  // namespace mlab::designer
