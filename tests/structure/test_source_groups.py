"""cmake/source_groups.py puts together only sources that mean the same together as apart: test_source_groups.py ROOT"""

import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(sys.argv.pop(1))
sys.path.insert(0, str(ROOT / "cmake"))
import source_groups  # noqa: E402

UNNAMED = """#include <vector>
namespace ndframe
{{
namespace
{{
{0}
}} // namespace
double answer{1}() {{ return 42; }}
}}
"""


def in_unnamed(text, number=0):
    return UNNAMED.format(text, number)


class SourceGroups(unittest.TestCase):
    def grouped(self, *texts):
        """The groups as numbers of the sources."""
        with tempfile.TemporaryDirectory() as folder:
            paths = [pathlib.Path(folder) / f"{i}.cpp" for i in range(len(texts))]
            for path, text in zip(paths, texts):
                path.write_text(text)
            groups = source_groups.groups([source_groups.Source(path) for path in paths])
        return [[int(source.path.stem) for source in group] for group in groups]

    def own(self, text):
        return source_groups.own_names(source_groups.without_text(in_unnamed(text)))

    def test_names_of_all_kinds_are_found(self):
        for text, name in (("double area(const Mesh& mesh, int cell)\n{\n  return mesh.at({cell});\n}", "area"),
                           ("struct Placed\n{\n  int node;\n  double at() const { return 1; }\n};", "Placed"),
                           ("enum class Kind { one, two };", "Kind"), ("using Blocks = std::map<std::pair<int, int>, int>;", "Blocks"),
                           ("constexpr double roundOff = 1e-12;", "roundOff"), ("std::mutex mutex; ///< of what follows", "mutex"),
                           ("const std::vector<int> corners{1, 2, 3};", "corners"), ("double table[3][2] = {{1, 2}};", "table"),
                           ("template <class T, int n>\nT sum(const std::vector<T>& all);", "sum"),
                           ("template <>\nint size<3>(const Mesh& mesh)\n{\n}", "size"),
                           ("template <class Test, std::enable_if_t<(n > 1), int> = 0>\nauto waited(Test test) -> int;", "waited"),
                           ("const std::function<double(int)> measure = []() { return 1; };", "measure"),
                           ("std::array<double, (n + 1) / 2> halves;", "halves"),
                           ("const auto [first, last] = ends();", "first"),
                           ("static int count, total;", "total")):
            with self.subTest(name):
                self.assertIn(name, self.own(text))

    def test_names_of_all_are_not_its_own(self):
        own = self.own("double area(const Mesh& mesh, int cell) { const double half = 0.5; return half; }")
        self.assertEqual(own, {"area"})

    def test_unnamed_namespaces_end(self):
        own = self.own("int a;\n}\nint everybodys;\nnamespace\n{\nint b;")
        self.assertEqual(own, {"a", "b"})

    def test_sources_without_common_names_go_together(self):
        self.assertEqual(self.grouped(in_unnamed("int a;"), in_unnamed("int b;", 1), in_unnamed("", 2)), [[0, 1, 2]])

    def test_one_name_twice_is_apart(self):
        self.assertEqual(self.grouped(in_unnamed("int a;"), in_unnamed("void a(double);", 1), in_unnamed("int c;", 2)), [[0, 2]])

    def test_a_name_that_another_source_only_uses_is_apart(self):
        """It may be a function of a header there: now it could be the other source's."""
        uses = "namespace ndframe { double twice(double x) { return scaled(2, x); } }"
        self.assertEqual(self.grouped(in_unnamed("double scaled(int a, double b);"), uses), [])
        self.assertEqual(self.grouped(uses, in_unnamed("double scaled(int a, double b);")), [])

    def test_sources_with_macros_are_alone(self):
        self.assertEqual(self.grouped("#define LANES 4\nint a();", "int b();"), [])

    def test_sources_of_kernels_in_a_header_are_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (("lanes.hpp", "#pragma once\n#pragma GCC ivdep\n"), ("plain.hpp", "#pragma once\n")):
                (pathlib.Path(folder) / name).write_text(text)
                (pathlib.Path(folder) / "a.cpp").write_text(f'#include "{name}"\n')
                self.assertEqual(source_groups.Source(pathlib.Path(folder) / "a.cpp").is_alone, name == "lanes.hpp")

    def test_comments_and_literals_are_no_names(self):
        other = '// area\n/* area\n */ const char* text() { return "area" R"(area " })"; } char c = \'{\'; int n = 10\'000;'
        self.assertEqual(self.grouped(in_unnamed("int area;"), other), [[0, 1]])

    def test_kernels_are_alone(self):
        for text in ("__attribute__((always_inline)) void f();", "#pragma GCC unroll 4", "#include <immintrin.h>"):
            self.assertEqual(self.grouped("int a();", text, "int b();"), [[0, 2]])

    def test_only_our_namespaces_are_used_as_a_whole(self):
        for used, groups in (("std::chrono", []), ("ndframe", [[0, 1]]), ("ndframe::test", [[0, 1]])):
            self.assertEqual(self.grouped(f"using namespace {used};", "int b();"), groups)

    def test_tests_have_names_of_their_own(self):
        self.assertEqual(self.grouped(in_unnamed("TEST(A, b) {}"), in_unnamed("TEST(A, c) {}\nTEST_P(B, a)\n{\n}", 1)), [[0, 1]])

    def test_groups_have_a_limit(self):
        texts = [in_unnamed("", number) for number in range(2 * source_groups.MOST_SOURCES + 1)]
        self.assertEqual([len(group) for group in self.grouped(*texts)], 2 * [source_groups.MOST_SOURCES])

    def test_sources_of_the_packages_go_together(self):
        """Names that everybody has - in all sources of a package - would leave nothing to gain."""
        units, sources = 0, 0
        for folder in sorted((ROOT / "packages").iterdir()):
            paths = sorted(folder.glob("src/**/*.cpp"))
            found = source_groups.groups([source_groups.Source(path) for path in paths])
            grouped = [source.path for group in found for source in group]
            self.assertEqual(len(grouped), len(set(grouped)))
            units += len(found) + len(paths) - len(grouped)
            sources += len(paths)
        self.assertLess(units, 0.4 * sources)


if __name__ == "__main__":
    unittest.main()
