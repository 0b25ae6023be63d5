#include <algorithm>
#include <concepts>
#include <string_view>
#include <type_traits>
#include <utility>

#include <fmt/core.h>

#include "mlab/difference/compare_owner.h"
#include "mlab/difference/declarations.h"
#include "mlab/difference/difference.h"
#include "mlab/difference/layouts.h"
#include "mlab/lang/cdl/syntax/lexer.h"

namespace mlab::difference {
namespace {

std::string call_words(const cdl::Call& call) {
  if (call.arguments.empty()) return call.callee.text;
  std::string out = call.callee.text + "(";
  for (const cdl::Argument& argument : call.arguments) {
    if (&argument != &call.arguments.front()) out += ", ";
    if (!argument.name.text.empty()) out += argument.name.text + " = ";
    if (argument.value) out += words_of(*argument.value);
  }
  return out + ")";
}

std::string member_words(const cdl::SocietyMember& member) {
  std::string out;
  if (member.kind == cdl::SocietyMember::Kind::kTeam) out = fmt::format("team of {} ", member.count);
  if (member.kind == cdl::SocietyMember::Kind::kCaste) {
    out = "caste {";
    for (const cdl::SocietyMember& one : member.members) out += fmt::format(" {};", member_words(one));
    out += " }";
  }
  out += member.name.text;
  return member.by.text.empty() ? out : out + " by " + member.by.text;
}

std::string type_of(const cdl::Parameter& parameter) {
  return parameter.unit.text.empty() ? parameter.type.text
                                     : fmt::format("{} [{}]", parameter.type.text, parameter.unit.text);
}

std::string range_of(const cdl::Parameter& parameter) {
  if (!parameter.low || !parameter.high) return "";
  const auto end = [](const cdl::Number& number) {
    return number.unit.text.empty() ? fmt::format("{}", number.value)
                                    : fmt::format("{} {}", number.value, number.unit.text);
  };
  return fmt::format("{} .. {}", end(*parameter.low), end(*parameter.high));
}

/// Two files.
class FileComparison {
 public:
  FileComparison(const Version& before, const Version& after)
      : before_(before),
        after_(after),
        olds_(declarations_of(before.tree)),
        news_(declarations_of(after.tree)),
        pairs_(match_declarations(olds_, news_, before.tree, after.tree)) {}

  Comparison run() {
    out_.is_partial = before_.has_errors || after_.has_errors;
    find_renames();
    compare_uses();
    for (std::size_t i = 0; i < olds_.size(); ++i) {
      if (pairs_.to_after[i] < 0) tell_declaration(olds_[i], What::kRemoved);
    }
    for (std::size_t k = 0; k < news_.size(); ++k) {
      if (pairs_.to_before[k] < 0)
        tell_declaration(news_[k], What::kAdded);
      else
        compare_declaration(olds_[static_cast<std::size_t>(pairs_.to_before[k])], news_[k]);
    }
    compare_layouts(before_.tree, after_.tree, out_);
    compare_texts();
    return std::move(out_);
  }

 private:
  void find_renames() {
    for (std::size_t i = 0; i < olds_.size(); ++i) {
      if (pairs_.to_after[i] < 0) continue;
      const Declaration& is = news_[static_cast<std::size_t>(pairs_.to_after[i])];
      if (olds_[i].name->text != is.name->text)
        renames_.declarations.emplace(olds_[i].name->text, is.name->text);
      if (olds_[i].parameters == nullptr) continue;
      const Pairs same = match_parameters(*olds_[i].parameters, *is.parameters);
      for (std::size_t p = 0; p < same.to_after.size(); ++p) {
        if (same.to_after[p] < 0) continue;
        const std::string& was_called = (*olds_[i].parameters)[p].name.text;
        const std::string& is_called = (*is.parameters)[static_cast<std::size_t>(same.to_after[p])].name.text;
        if (was_called != is_called) renames_.parameters[olds_[i].name->text].emplace(was_called, is_called);
      }
    }
  }

  // ---- what stands for itself

  void tell(Thing thing, const char* kind, What what, const cdl::Word& word) {
    Difference one;
    one.thing = thing;
    one.kind = kind;
    one.what = what;
    (what == What::kAdded ? one.name_after : one.name_before) = word.text;
    (what == What::kAdded ? one.place_after : one.place_before) = word.place;
    out_.meaning.push_back(std::move(one));
  }

  template <class Kind>
  void compare_words(Thing thing, const char* kind, const auto& word_of) {
    const auto all = [&](const cdl::Tree& tree) {
      std::vector<const cdl::Word*> out;
      for (const cdl::Item& item : tree.items) {
        if (const auto* one = std::get_if<Kind>(&item)) out.push_back(&word_of(*one));
      }
      return out;
    };
    const auto was = all(before_.tree);
    const auto is = all(after_.tree);
    Pairs same(was.size(), is.size());
    pair_by(same, [&](std::size_t i) { return was[i]->text; }, [&](std::size_t i) { return is[i]->text; });
    for (std::size_t i = 0; i < was.size(); ++i)
      if (same.to_after[i] < 0) tell(thing, kind, What::kRemoved, *was[i]);
    for (std::size_t i = 0; i < is.size(); ++i)
      if (same.to_before[i] < 0) tell(thing, kind, What::kAdded, *is[i]);
  }

  void compare_uses() {
    compare_words<cdl::Use>(Thing::kUse, "use", [](const cdl::Use& use) -> const auto& { return use.path; });
    compare_words<cdl::Architecture>(Thing::kArchitecture, "architecture",
                                     [](const cdl::Architecture& one) -> const auto& { return one.name; });
  }

  void tell_declaration(const Declaration& one, What what) {
    tell(Thing::kDeclaration, one.kind, what, *one.name);
  }

  // ---- one declaration

  static Difference of_declaration(const Declaration& was, const Declaration& is) {
    Difference one;
    one.thing = Thing::kDeclaration;
    one.kind = is.kind;
    one.name_before = was.name->text;
    one.name_after = is.name->text;
    one.place_before = was.name->place;
    one.place_after = is.name->place;
    return one;
  }

  void compare_declaration(const Declaration& was, const Declaration& is) {
    out_.owners.emplace_back(was.name->text, is.name->text);
    Renames renames(renames_);
    if (const auto found = renames_.parameters.find(was.name->text); found != renames_.parameters.end())
      renames.own = found->second;
    Difference one = of_declaration(was, is);
    note(one, "name", was.name->text, is.name->text);
    note(one, "help", *was.help, *is.help);
    std::visit(
        [&](const auto& now) {
          using Kind = std::remove_cvref_t<decltype(now)>;
          if constexpr (requires { now.name; }) compare_own(std::get<Kind>(*was.item), now, renames, one);
        },
        *is.item);
    // What it is stands before what it consists of.
    const std::size_t before_parts = out_.meaning.size();
    if (was.parameters != nullptr) compare_parameters(was, is, renames);
    std::visit(
        [&](const auto& now) {
          using Kind = std::remove_cvref_t<decltype(now)>;
          if constexpr (requires { now.name; }) compare_parts(std::get<Kind>(*was.item), now, renames);
        },
        *is.item);
    if (settle(one))
      out_.meaning.insert(out_.meaning.begin() + static_cast<std::ptrdiff_t>(before_parts), std::move(one));
  }

  void compare_parameters(const Declaration& was, const Declaration& is, const Renames& renames) {
    const Pairs same = match_parameters(*was.parameters, *is.parameters);
    compare_each(
        *was.parameters, *is.parameters, same, Thing::kParameter, was.name->text, is.name->text,
        [](const cdl::Parameter&) { return "parameter"; },
        [](const cdl::Parameter& one) -> const cdl::Word& { return one.name; },
        [&](const cdl::Parameter& before, const cdl::Parameter& after, Difference& out) {
          Prints prints(renames);
          note(out, "type", type_of(before), type_of(after));
          if (prints.before.of(before.initial) != prints.after.of(after.initial))
            out.details.push_back({"default", before.initial ? words_of(*before.initial) : "",
                                   after.initial ? words_of(*after.initial) : ""});
          note(out, "range", range_of(before), range_of(after));
          note(out, "help", before.help, after.help);
        });
    if (!same.keep_order()) tell_order(was, is);
  }

  // Arguments without a name go by it.
  void tell_order(const Declaration& was, const Declaration& is) {
    Difference one = of_declaration(was, is);
    const auto names = [](const std::vector<cdl::Parameter>& all) {
      std::string out;
      for (const cdl::Parameter& one_name : all) out += (out.empty() ? "" : ", ") + one_name.name.text;
      return out;
    };
    one.details.push_back({"order of parameters", names(*was.parameters), names(*is.parameters)});
    out_.meaning.push_back(std::move(one));
  }

  /// Statements of which each has a name.
  template <class Kind>
  void compare_each(const std::vector<Kind>& was, const std::vector<Kind>& is, const Pairs& same, Thing thing,
                    const std::string& owner_before, const std::string& owner_after, const auto& kind_of,
                    const auto& name_of, const auto& details) {
    const auto base = [&](const Kind& one) {
      Difference out;
      out.thing = thing;
      out.kind = kind_of(one);
      out.page_before = owner_before;
      out.page_after = owner_after;
      return out;
    };
    const auto alone = [&](const Kind& kind, What what) {
      Difference out = base(kind);
      out.what = what;
      (what == What::kAdded ? out.name_after : out.name_before) = name_of(kind).text;
      (what == What::kAdded ? out.place_after : out.place_before) = name_of(kind).place;
      out_.meaning.push_back(std::move(out));
    };
    for (std::size_t i = 0; i < was.size(); ++i)
      if (same.to_after[i] < 0) alone(was[i], What::kRemoved);
    for (std::size_t k = 0; k < is.size(); ++k) {
      if (same.to_before[k] < 0) {
        alone(is[k], What::kAdded);
        continue;
      }
      const Kind& before = was[static_cast<std::size_t>(same.to_before[k])];
      Difference out = base(is[k]);
      out.name_before = name_of(before).text;
      out.name_after = name_of(is[k]).text;
      out.place_before = name_of(before).place;
      out.place_after = name_of(is[k]).place;
      note(out, "name", out.name_before, out.name_after);
      details(before, is[k], out);
      if (settle(out)) out_.meaning.push_back(std::move(out));
    }
  }

  template <class Kind>
  static Pairs by_name(const std::vector<Kind>& was, const std::vector<Kind>& is, const auto& name_of) {
    Pairs out(was.size(), is.size());
    pair_by(
        out, [&](std::size_t i) { return name_of(was[i]).text; },
        [&](std::size_t i) { return name_of(is[i]).text; });
    return out;
  }

  // ---- what one kind has

  static void compare_own(const cdl::Assemblage& was, const cdl::Assemblage& is, const Renames& /*r*/,
                          Difference& out) {
    note(out, "result type", was.result_type.text, is.result_type.text);
    const auto names = [](const cdl::Assemblage& one) {
      std::string text;
      for (const cdl::Word& word : one.historic_names) text += (text.empty() ? "" : ", ") + word.text;
      return text;
    };
    note(out, "historic names", names(was), names(is));
  }
  static void compare_own(const cdl::Binding& was, const cdl::Binding& is, const Renames& /*r*/,
                          Difference& out) {
    note(out, "result type", was.result_type.text, is.result_type.text);
  }
  static void compare_own(const cdl::Robot& was, const cdl::Robot& is, const Renames& renames,
                          Difference& out) {
    if (renames.declaration(was.class_name.text) != is.class_name.text)
      note(out, "class", was.class_name.text, is.class_name.text);
  }
  static void compare_own(const cdl::Society& was, const cdl::Society& is, const Renames& renames,
                          Difference& out) {
    Prints prints(renames);
    compare_members(was.what, is.what, prints, out);
  }
  // By name; those of one name that differ are told with what they say before and after.
  static void compare_test_lets(const std::vector<cdl::Let>& was, const std::vector<cdl::Let>& is,
                                Prints& prints, Difference& out) {
    const auto named = [](const std::vector<cdl::Let>& lets, const std::string& name) {
      const auto found = std::ranges::find(lets, name, [](const cdl::Let& let) { return let.name.text; });
      return found == lets.end() ? nullptr : &*found;
    };
    const auto words = [](const cdl::Let* let) {
      return let == nullptr || !let->value ? std::string() : words_of(*let->value);
    };
    const std::size_t before = out.details.size();
    for (const cdl::Let& let : was) {
      const cdl::Let* after = named(is, let.name.text);
      if (after == nullptr || prints.before.of(let.value) != prints.after.of(after->value))
        out.details.push_back({"let " + let.name.text, words(&let), words(after)});
    }
    for (const cdl::Let& let : is) {
      if (named(was, let.name.text) == nullptr)
        out.details.push_back({"let " + let.name.text, "", words(&let)});
    }
    // Their order, or the words of their help.
    if (out.details.size() == before && prints.before.of(was) != prints.after.of(is))
      out.details.push_back({"lets", "", ""});
  }
  // Step by step where only words of steps differ.
  static void compare_own(const cdl::Test& was, const cdl::Test& is, const Renames& renames,
                          Difference& out) {
    Prints prints(renames);
    if (prints.before.of(was.subject) != prints.after.of(is.subject))
      out.details.push_back(
          {"subject", was.subject ? words_of(*was.subject) : "", is.subject ? words_of(*is.subject) : ""});
    if (renames.declaration(was.class_name.text) != is.class_name.text)
      note(out, "class", was.class_name.text, is.class_name.text);
    compare_test_lets(was.lets, is.lets, prints, out);
    const std::size_t most = std::max(was.steps.size(), is.steps.size());
    const auto words = [](const cdl::Test& test, std::size_t i) {
      if (i >= test.steps.size()) return std::string();
      const text::Place& place = test.steps[i].place;
      return place.source ? std::string(place.source->text(place.span)) : std::string();
    };
    for (std::size_t i = 0; i < most; ++i) {
      const bool is_same = i < was.steps.size() && i < is.steps.size() &&
                           prints.before.of(was.steps[i]) == prints.after.of(is.steps[i]);
      if (!is_same) out.details.push_back({fmt::format("step {}", i + 1), words(was, i), words(is, i)});
    }
  }
  template <class Kind>
  static void compare_own(const Kind& /*was*/, const Kind& /*is*/, const Renames& /*r*/,
                          Difference& /*out*/) {}

  // Castes member by member.
  static void compare_members(const cdl::SocietyMember& was, const cdl::SocietyMember& is, Prints& prints,
                              Difference& out) {
    if (prints.before.of(was) == prints.after.of(is)) return;
    constexpr auto kCaste = cdl::SocietyMember::Kind::kCaste;
    if (was.kind != kCaste || is.kind != kCaste) {
      out.details.push_back({"members", member_words(was), member_words(is)});
      return;
    }
    if (prints.renames.declaration(was.by.text) != is.by.text)
      note(out, "coordinated by", was.by.text, is.by.text);
    Pairs same(was.members.size(), is.members.size());
    pair_by(
        same, [&](std::size_t i) { return prints.before.of(was.members[i]); },
        [&](std::size_t k) { return prints.after.of(is.members[k]); });
    const auto name = [](const cdl::SocietyMember& member, const std::string& called) {
      return member.kind == kCaste ? "caste" : "of " + called;
    };
    pair_by(
        same,
        [&](std::size_t i) {
          const cdl::SocietyMember& one = was.members[i];
          return name(one, prints.renames.declaration(one.name.text));
        },
        [&](std::size_t k) { return name(is.members[k], is.members[k].name.text); });
    for (std::size_t i = 0; i < was.members.size(); ++i)
      if (same.to_after[i] < 0) out.details.push_back({"member", member_words(was.members[i]), ""});
    for (std::size_t k = 0; k < is.members.size(); ++k) {
      if (same.to_before[k] < 0)
        out.details.push_back({"member", "", member_words(is.members[k])});
      else
        compare_members(was.members[static_cast<std::size_t>(same.to_before[k])], is.members[k], prints, out);
    }
    if (!same.keep_order()) out.details.push_back({"order of members", member_words(was), member_words(is)});
  }

  // ---- what stands in one

  void compare_parts(const cdl::Assemblage& was, const cdl::Assemblage& is, const Renames& renames) {
    compare_drawings(was, is, renames);
  }
  void compare_parts(const cdl::Robot& was, const cdl::Robot& is, const Renames& renames) {
    const auto name_of = [](const cdl::Choice& one) -> const cdl::Word& { return one.binding; };
    compare_each(
        was.choices, is.choices, by_name(was.choices, is.choices, name_of), Thing::kChoice, was.name.text,
        is.name.text, [](const cdl::Choice&) { return "device used for"; }, name_of,
        [](const cdl::Choice& before, const cdl::Choice& after, Difference& out) {
          note(out, "device", before.device.text, after.device.text);
        });
    compare_drawings(was, is, renames);
  }
  void compare_parts(const cdl::RobotClass& was, const cdl::RobotClass& is, const Renames& renames) {
    const auto name_of = [](const cdl::BodySetting& one) -> const cdl::Word& { return one.name; };
    compare_each(
        was.body, is.body, by_name(was.body, is.body, name_of), Thing::kSetting, was.name.text, is.name.text,
        [](const cdl::BodySetting&) { return "body"; }, name_of,
        [&](const cdl::BodySetting& before, const cdl::BodySetting& after, Difference& out) {
          Prints prints(renames);
          if (prints.before.of(before.value) == prints.after.of(after.value)) return;
          out.details.push_back({"value", before.value ? words_of(*before.value) : "",
                                 after.value ? words_of(*after.value) : ""});
        });
    compare_devices(was.devices, is.devices, was.name.text, is.name.text, renames);
  }
  void compare_parts(const cdl::SocietyOperator& was, const cdl::SocietyOperator& is,
                     const Renames& renames) {
    compare_devices(was.devices, is.devices, was.name.text, is.name.text, renames);
  }
  template <class Kind>
  void compare_parts(const Kind& /*was*/, const Kind& /*is*/, const Renames& /*r*/) {}

  void compare_devices(const std::vector<cdl::Device>& was, const std::vector<cdl::Device>& is,
                       const std::string& owner_before, const std::string& owner_after,
                       const Renames& renames) {
    const auto name_of = [](const cdl::Device& one) -> const cdl::Word& {
      return one.name.text.empty() ? one.binds : one.name;
    };
    Pairs same = by_name(was, is, name_of);
    Prints prints(renames);
    const auto nameless = [](const cdl::Device& device, Fingerprints& fingerprints) {
      cdl::Device copy = device;
      copy.name.text.clear();
      return fingerprints.of(copy);
    };
    pair_by(
        same, [&](std::size_t i) { return nameless(was[i], prints.before); },
        [&](std::size_t k) { return nameless(is[k], prints.after); });
    compare_each(
        was, is, same, Thing::kDevice, owner_before, owner_after,
        [&](const cdl::Device& one) {
          return one.name.text.empty() ? "binding" : one.is_actuator ? "actuator" : "sensor";
        },
        name_of,
        [&](const cdl::Device& before, const cdl::Device& after, Difference& out) {
          if (prints.before.of(before.by) != prints.after.of(after.by))
            out.details.push_back({"served by", call_words(before.by), call_words(after.by)});
          if (renames.declaration(before.binds.text) != after.binds.text)
            note(out, "binds", before.binds.text, after.binds.text);
          note(out, "kind", before.is_actuator ? "actuator" : "sensor",
               after.is_actuator ? "actuator" : "sensor");
          note(out, "help", before.help, after.help);
        });
  }

  // Pages are made only of what says something else.
  template <class Owner>
  void compare_drawings(const Owner& was, const Owner& is, Renames renames) {
    if (is_same(was, is)) return;
    renames.own.merge(renamed_lets(was.lets, is.lets, renames));
    const cdl::OwnerModel before = cdl::model_of(was, before_.elaboration);
    const cdl::OwnerModel after = cdl::model_of(is, after_.elaboration);
    compare_owner(before, after, renames, out_);
  }
  template <class Owner>
  static bool is_same(const Owner& was, const Owner& is) {
    const Renames none;
    Prints prints(none);
    const auto help = [](const Owner& owner) {
      std::string out;
      for (const cdl::Let& let : owner.lets) out += let.help + '\n';
      cdl::for_each_construct(owner, [&](const auto& one) {
        using Kind = std::remove_cvref_t<decltype(one)>;
        if constexpr (std::same_as<Kind, cdl::State> || std::same_as<Kind, cdl::Transition>)
          out += one.help + '\n';
      });
      return out;
    };
    return prints.before.of(was) == prints.after.of(is) && help(was) == help(is);
  }

  // ---- the texts themselves

  struct Spelled {
    std::vector<std::string_view> words;
    std::vector<std::string_view> layouts;  // the words in them
    std::vector<std::string_view> comments;
  };
  static Spelled spelled(const cdl::Tree& tree) {
    Spelled out;
    const std::string_view text = tree.source->text();
    std::vector<text::Span> layouts;
    for (const cdl::Item& item : tree.items) {
      if (const auto* layout = std::get_if<cdl::Layout>(&item)) layouts.push_back(layout->whole);
    }
    std::size_t next = 0;
    const cdl::Tokens tokens = cdl::lex(text);
    const auto words = [&](text::Span span) { return text.substr(span.begin, span.end - span.begin); };
    for (const cdl::Token& token : tokens.tokens) {
      while (next < layouts.size() && layouts[next].end <= token.span.begin) ++next;
      const bool is_layout = next < layouts.size() && token.span.begin >= layouts[next].begin;
      (is_layout ? out.layouts : out.words).push_back(words(token.span));
    }
    for (const cdl::Comment& comment : tokens.comments) out.comments.push_back(words(comment.span));
    return out;
  }
  void compare_texts() {
    if (!before_.tree.source || !after_.tree.source) return;
    out_.is_same_text = before_.tree.source->text() == after_.tree.source->text();
    if (out_.is_same_text) return;
    const Spelled was = spelled(before_.tree);
    const Spelled is = spelled(after_.tree);
    out_.has_other_comments = was.comments != is.comments;
    out_.has_other_layout = was.layouts != is.layouts;
    out_.is_written_otherwise = out_.meaning.empty() && was.words != is.words;
  }

  const Version& before_;
  const Version& after_;
  std::vector<Declaration> olds_;
  std::vector<Declaration> news_;
  Pairs pairs_;
  DeclarationRenames renames_;
  Comparison out_;
};

}  // namespace

Comparison compare(const Version& before, const Version& after) {
  return FileComparison(before, after).run();
}

}  // namespace mlab::difference
