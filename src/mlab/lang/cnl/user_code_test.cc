#include "mlab/lang/cnl/user_code.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace mlab::cnl {
namespace {

UserCode code(const std::string& text) {
  const auto source = std::make_shared<const text::Source>("a.cnl", text);
  return UserCode(Code{{source, {0, static_cast<std::uint32_t>(text.size())}}});
}

std::string names(const std::string& text) {
  std::string out;
  const UserCode read = code(text);
  for (const UserCode::Variable& v : read.variables()) {
    out += v.name + (v.is_pointer ? "*" : "") + (v.is_constant ? "!" : "") + (v.holds_references ? "&" : "") +
           " ";
  }
  return out;
}

TEST(UserCodeVariables, ReadsWhatDeclaresAVariable) {
  EXPECT_EQ(names("int n = 0;"), "n ");
  EXPECT_EQ(names("int a, b = f(1, 2), c[3] = {1, 2, 3}, d{4}, e(5);"), "a b c d e ");
  EXPECT_EQ(names("unsigned long long big; const double x = 1; double const y = 2;"), "big x y ");
  EXPECT_EQ(names("std::array<std::pair<int, double>, 4> t{}; ::geom::Vector v;"), "t v ");
  EXPECT_EQ(names("auto [p, q] = f(); auto g = [](int i) { int inner = i; return inner; };"), "p q g ");
  EXPECT_EQ(names("struct { int x; } s, t{1}; struct P { int y; }; P p;"), "s t p ");
  EXPECT_EQ(names("enum Mode { kA, kB }; Mode m = kA; [[maybe_unused]] int u;"), "m u ");
  EXPECT_EQ(names("static constexpr int kTable[] = {1}; decltype(u) w = 5;"), "kTable! w ");
}

TEST(UserCodeVariables, PassesOverWhatIsNone) {
  EXPECT_EQ(names("n = 5; f(x); a.b = 2; ++n; p->q(); return; x < y; std::cout << n << m;"), "");
  EXPECT_EQ(names("if (int k = f()) { int inside; } else { int other; } for (int i = 0; i < 3; ++i) int j;"),
            "");
  EXPECT_EQ(names("{ int scoped; } using namespace std; // int comment;\n/* int block; */"), "");
  EXPECT_EQ(names("#define X int macro;\nX;\n#define Y \\\n int more;\n const char c = ';'; int z;"), "c z ");
  EXPECT_EQ(names("f(\"int text;\", R\"(int raw; \" )\"); int end = 1'000;"), "end ");
}

TEST(UserCodeVariables, SeesPointersReferencesAndWhatHidesThem) {
  EXPECT_EQ(names("int* p; int *q, r; int& s = x; auto&& t = f(); const char* u = \"\";"),
            "p* q* r s* t* u* ");
  EXPECT_EQ(names("std::string_view v; std::span<int> w; std::array<int*, 2> x; auto y = &n;"),
            "v* w* x* y* ");
  EXPECT_EQ(
      names("auto f = [&](int i) { return i; }; auto g = [&n] { return n; }; auto h = [=] { return 1; };"),
      "f& g& h ");
}

TEST(UserCode, KnowsWhichNamesItUses) {
  const UserCode c = code("percepts.time + self->random + std::cycle; // action\n \"output\"");
  EXPECT_TRUE(c.mentions("percepts"));
  EXPECT_FALSE(c.mentions("time"));
  EXPECT_FALSE(c.mentions("random"));
  EXPECT_FALSE(c.mentions("cycle"));
  EXPECT_FALSE(c.mentions("action"));
  EXPECT_FALSE(c.mentions("output"));
}

TEST(UserCode, IsBlankWithNothingButComments) {
  EXPECT_TRUE(code(" // nothing\n /* at all */ \n").is_blank());
  EXPECT_FALSE(code("#define X\n").is_blank());
  EXPECT_FALSE(code(";").is_blank());
}

}  // namespace
}  // namespace mlab::cnl
