"""Every rule of the structure check refuses a bad sample, and the check lets a good tree pass."""

import pathlib
import subprocess
import sys
import tempfile
import textwrap
import unittest

import cpp_text
import structure_rules
from structure_rules import Tree

GOOD_HEADER = "#pragma once\n\nint answer();\n"
GOOD_TREE = {
    "packages/base/CMakeLists.txt": "ndframe_package(base\n  SOURCES src/a.cpp\n  LIBRARIES x)\n",
    "packages/base/include/ndframe/base/a.hpp": GOOD_HEADER,
    "packages/base/src/a.cpp": '#include "ndframe/base/a.hpp"\n\nint answer() { return 42; }\n',
    "packages/mesh/CMakeLists.txt": "ndframe_package(mesh\n  SOURCES src/m.cpp\n  DEPENDS base # algebra\n  LIBRARIES x)\n",
    "packages/mesh/src/m.cpp": '#include <vector>\n#include "ndframe/base/a.hpp"\n',
    "packages/algebra/CMakeLists.txt": "ndframe_package(algebra SOURCES src/t.cpp DEPENDS base)\n",
    "packages/algebra/src/t.cpp": "#include <mpi.h>\n",
    "packages/krylov/CMakeLists.txt": "ndframe_package(krylov MODULE\n  SOURCES src/k.cpp\n  DEPENDS algebra)\n",
    "packages/krylov/src/k.cpp": "#include <Tpetra_CrsMatrix.hpp>\n",
    "apps/main.cpp": '#include "ndframe/base/a.hpp"\n\nint main() { return answer(); }\n',
}


def function_of(num_lines, name="f"):
    return f"int {name}()\n{{\n" + "  ++n;\n" * (num_lines - 3) + "}\n"


class StructureCheck(unittest.TestCase):
    def found(self, **files):
        """The problems of the good tree with some files replaced; keys are paths with / and . spelt __ and _dot_."""
        return self.found_in({**GOOD_TREE, **{k.replace("__", "/").replace("_dot_", "."): v for k, v in files.items()}})

    def found_in(self, files):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                path = pathlib.Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            return [str(problem) for problem in structure_rules.problems(Tree(folder))]

    def assert_one(self, problems, file_and_line, words):
        self.assertEqual(len(problems), 1, problems)
        self.assertTrue(problems[0].startswith(file_and_line + ": "), problems[0])
        self.assertIn(words, problems[0])

    def test_a_good_tree_passes(self):
        self.assertEqual(self.found(), [])

    def test_include_against_the_arrows(self):
        problems = self.found(packages__base__src__b_dot_cpp='\n#include "ndframe/mesh/mesh.hpp"\n')
        self.assertIn("packages/base/src/b.cpp:2: base may not include mesh: it is against the arrows", problems)

    def test_include_between_sisters(self):
        problems = self.found(packages__mesh__src__m_dot_cpp='#include "ndframe/algebra/comm.hpp"\n')
        self.assertIn("packages/mesh/src/m.cpp:1: mesh may not include algebra: it is against the arrows", problems)

    def test_transitive_include_is_allowed(self):
        problems = self.found(
            packages__fem__CMakeLists_dot_txt="ndframe_package(fem SOURCES src/f.cpp DEPENDS mesh)",
            packages__fem__src__f_dot_cpp='#include "ndframe/base/a.hpp"\n',
        )
        self.assertEqual(problems, [])

    def test_estimation_never_sees_the_coupling(self):
        self.assertNotIn("coupling", structure_rules.reachable("estimation", structure_rules.ARROWS))
        self.assertNotIn("subdomain", structure_rules.reachable("estimation", structure_rules.ARROWS))

    def test_include_around_the_public_headers(self):
        problems = self.found(packages__mesh__src__m_dot_cpp='#include "../../base/src/a.hpp"\n')
        self.assert_one(problems, "packages/mesh/src/m.cpp:1", "reaches into another folder")

    def test_cycle_in_the_table(self):
        problems = list(structure_rules.arrows_have_no_cycle(None, {"a": ["b"], "b": ["c"], "c": ["a"], "d": ["a"]}))
        self.assertEqual(len(problems), 3)

    def test_cycle_between_headers(self):
        problems = self.found(
            packages__base__include__ndframe__base__a_dot_hpp='#pragma once\n#include "ndframe/base/b.hpp"\n',
            packages__base__include__ndframe__base__b_dot_hpp='#pragma once\n#include "ndframe/base/a.hpp"\n',
        )
        self.assertEqual(len(problems), 2)
        self.assertIn("includes itself", problems[0])

    def test_package_without_arrows(self):
        problems = self.found(packages__magic__CMakeLists_dot_txt="ndframe_package(magic SOURCES src/a.cpp)")
        self.assert_one(problems, "packages/magic:1", "no arrows in the table")

    def test_package_without_cmake(self):
        problems = self.found(packages__fem__src__a_dot_cpp="\n")
        self.assert_one(problems, "packages/fem/CMakeLists.txt:1", "no CMakeLists.txt")

    def test_cmake_depends_against_the_arrows(self):
        problems = self.found(packages__base__CMakeLists_dot_txt="ndframe_package(base SOURCES a.cpp DEPENDS mesh)")
        self.assert_one(problems, "packages/base/CMakeLists.txt:1", "DEPENDS mesh is against the arrows")

    def test_include_that_cmake_does_not_link(self):
        problems = self.found(packages__mesh__CMakeLists_dot_txt="ndframe_package(mesh SOURCES src/m.cpp)")
        self.assert_one(problems, "packages/mesh/src/m.cpp:2", "not among the DEPENDS")

    def test_heavy_headers(self):
        module = ["Tpetra_Map.hpp", "BelosSolverFactory.hpp", "Ifpack2_Factory.hpp", "Amesos2.hpp", "MueLu.hpp"]
        module += ["Kokkos_Core.hpp", "Xpetra_Map.hpp"]
        places = ["packages/mesh/src/x.cpp", "packages/algebra/include/ndframe/algebra/x.hpp", "tests/mesh/x.cpp"]
        self.assert_heavy(["cholmod.h", "suitesparse/cholmod.h", "dmumps_c.h", "mpi.h"], places)
        self.assert_heavy(module, places + ["packages/algebra/src/x.cpp"])

    def assert_heavy(self, headers, places):
        tree = {**GOOD_TREE, "packages/algebra/src/u.cpp": '#include "ndframe/algebra/x.hpp"\n'}
        for header in headers:
            for place in places:
                with self.subTest(header=header, place=place):
                    problems = self.found_in({**tree, place: f"#pragma once\n#include <{header}>\n"})
                    self.assert_one(problems, f"{place}:2", "heavy header")

    def test_slow_headers(self):
        for header in ("nlohmann/json.hpp", "fmt/format.h", "CGAL/Constrained_Delaunay_triangulation_2.h", "iostream", "Teuchos_ParameterList.hpp"):
            with self.subTest(header):
                text = f"#pragma once\n#include <{header}>\n"
                self.assert_one(self.found(packages__base__include__ndframe__base__a_dot_hpp=text),
                                "packages/base/include/ndframe/base/a.hpp:2", "slows down all")
                self.assertEqual(self.found(packages__base__src__a_dot_cpp=f'#include "ndframe/base/a.hpp"\n#include <{header}>\n'), [])

    def test_whole_decks_below_the_driver(self):
        taken = "#pragma once\n\nvoid check(const Model& model, const Params& deck);\n"
        problems = self.found(packages__base__include__ndframe__base__a_dot_hpp=taken)
        self.assert_one(problems, "packages/base/include/ndframe/base/a.hpp:3", "takes the whole deck")
        problems = self.found(packages__mesh__src__m_dot_cpp="struct Step\n{\n  const Params& deck_;\n};\n")
        self.assert_one(problems, "packages/mesh/src/m.cpp:3", "takes the whole deck")
        for allowed in ("void build(const Params& list); // not const Params& deck\n", "int f(const DeckList& deck);\n"):
            self.assertEqual(self.found(packages__mesh__src__m_dot_cpp=allowed), [])
        files = {**GOOD_TREE, "packages/mesh/src/scene_settings.cpp": "int readScene(const Params& deck);\n"}
        self.assertEqual(self.found_in(files), [])

    def test_long_files(self):
        problems = self.found(packages__mesh__src__m_dot_cpp="int a;\n" * 300)
        self.assertEqual(problems, [])
        problems = self.found(packages__mesh__src__m_dot_cpp="int a;\n" * 301)
        self.assert_one(problems, "packages/mesh/src/m.cpp:301", "301 lines")
        problems = self.found(packages__base__include__ndframe__base__a_dot_hpp="#pragma once\n" + "int a;\n" * 150)
        self.assert_one(problems, "packages/base/include/ndframe/base/a.hpp:151", "151 lines")

    def test_large_packages(self):
        def files(count):  # of 250 lines each; comments and blank lines count
            return {f"packages/mesh/src/f{i}.cpp": "// a line\n\n" * 125 for i in range(count)}

        self.assertEqual(self.found_in({**GOOD_TREE, **files(23)}), [])
        problems = self.found_in({**GOOD_TREE, **files(24)})
        self.assert_one(problems, "packages/mesh:1", "6002 lines of sources and headers; a package has at most 6000")

    def test_long_functions(self):
        self.assertEqual(self.found(packages__mesh__src__m_dot_cpp=function_of(40)), [])
        problems = self.found(packages__mesh__src__m_dot_cpp="int n;\n\n" + function_of(41, "grow"))
        self.assert_one(problems, "packages/mesh/src/m.cpp:3", "grow has 41 lines")

    def test_chain_over_names(self):
        chain = 'int f(S t)\n{\n  if (t == "Box") return 1;\n  else if (t == "Gmsh") return 2;\n%s  return 3;\n}\n'
        self.assertEqual(self.found(packages__mesh__src__m_dot_cpp=chain % ""), [])
        self.assertEqual(self.found(packages__mesh__src__m_dot_cpp=chain % '  // t == "Exodus"\n'), [])
        problems = self.found(packages__mesh__src__m_dot_cpp=chain % '  if ("Exodus" == t) return 4;\n')
        self.assert_one(problems, "packages/mesh/src/m.cpp:1", 'f compares with "Box", "Exodus", "Gmsh"')

    def test_thrown_type_outside_the_exceptions(self):
        thrown = "%s\nvoid f()\n{\n  throw Bad{1};\n}\n"
        for good in ("class Bad : public std::runtime_error\n{\n};", "", "class Bad final : public Worse {};\n"
                     "class Worse : public std::exception {};"):
            if good:
                self.assertEqual(self.found(packages__mesh__src__m_dot_cpp=thrown % good), [])
        for bad in ("struct Bad\n{\n};", "struct Worse {};\nstruct Bad : public Worse {};"):
            problems = self.found(packages__mesh__src__m_dot_cpp=thrown % bad)
            self.assertEqual(len(problems), 1, problems)
            self.assertIn("Bad is no std::exception", problems[0])

    def test_product_widened_too_late(self):
        for good in ("std::size_t(a) * std::size_t(b * 2 > c)", "std::size_t(f(a * b))", "std::size_t(*a)", "// size_t(a * b)"):
            with self.subTest(good):
                good = good.replace("b * 2 > c", "g(b * 2)")
                self.assertEqual(self.found(packages__mesh__src__m_dot_cpp=f"auto n = 1; {good};\n"), [])
        for bad in ("std::size_t(a * b)", "std::ptrdiff_t(c + a\n * b)", "std::int64_t(f(a) * 2)"):
            problems = self.found(packages__mesh__src__m_dot_cpp=f"auto n =\n {bad};\n")
            self.assert_one(problems, "packages/mesh/src/m.cpp:2", "widened too late")

    def test_iterations_on_all_dofs(self):
        for good in ("K.numRows()", "// K.numDofs()", "std::size_t(nodes.numOwned())", "nodes.globalSize() * dim"):
            with self.subTest(good):
                self.assertEqual(self.found(packages__krylov__src__k_dot_cpp=f"auto n = 1; {good};\n"), [])
        for bad in ("Vector u(K.numDofs())", "gathered(K, u)", "Vector x(std::size_t(K.nodes.globalSize()))", "SolverProblem p"):
            with self.subTest(bad):
                problems = self.found(packages__krylov__src__k_dot_cpp=f"\nauto a = 1; {bad};\n")
                self.assert_one(problems, "packages/krylov/src/k.cpp:2", "as large as all ranks' nodes")
                self.assertEqual(self.found(packages__mesh__src__m_dot_cpp=f"auto a = 1; {bad};\n"), [])

    def test_iterations_that_need_no_exception(self):
        name = "packages/iterative/src/krylov_body.cpp"
        tree = {**GOOD_TREE, "packages/iterative/CMakeLists.txt": "ndframe_package(iterative SOURCES src/krylov_body.cpp)\n"}
        self.assertEqual(self.found_in({**tree, name: "int n = K.numDofs();\n"}), [])
        self.assert_one(self.found_in({**tree, name: "int n = 1;\n"}), f"{name}:1", "take it from MAY_SEE_ALL_RANKS")

    def test_unfinished_work(self):
        for word in ("TO" "DO", "FIX" "ME", "XX" "X"):
            for place in ("packages/mesh/src/m.cpp", "tests/mesh/t.py", "cmake/x.cmake"):
                with self.subTest(word=word, place=place):
                    self.assert_one(self.found_in({**GOOD_TREE, place: f"\n// {word}: later\n"}), f"{place}:2", word)

    def test_missing_guard(self):
        problems = self.found(packages__base__include__ndframe__base__a_dot_hpp="// #pragma once\nint a;\n")
        self.assert_one(problems, "packages/base/include/ndframe/base/a.hpp:1", "#pragma once is missing")

    def test_header_that_no_file_includes(self):
        problems = self.found(packages__mesh__src__m_dot_hpp="#pragma once\n")
        self.assert_one(problems, "packages/mesh/src/m.hpp:1", "no file includes it")

    def test_the_program_prints_problems_and_fails(self):
        script = pathlib.Path(__file__).parent / "check_structure.py"
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "packages" / "magic").mkdir(parents=True)
            run = subprocess.run([sys.executable, script, folder], capture_output=True, text=True)
        self.assertEqual(run.returncode, 1)
        self.assertIn("packages/magic:1: ", run.stdout)

    def test_two_classes_of_one_name(self):
        two = "#pragma once\n\nstruct Answer\n{\n  int value;\n};\n"
        other = {"packages__mesh__include__ndframe__mesh__b_dot_hpp": two}
        source = {"packages__mesh__src__m_dot_cpp": '#include "ndframe/mesh/b.hpp"\n#include "ndframe/base/a.hpp"\n'}
        unnamed = two.replace("struct", "namespace\n{\nstruct") + "} // namespace\n"
        problems = lambda header: self.found(**other, **source, packages__base__include__ndframe__base__a_dot_hpp=header)
        self.assertTrue(any("has a class Answer, too" in str(problem) for problem in problems(two)), problems(two))
        for header in (GOOD_HEADER, unnamed, "#pragma once\n\nstruct Answer;\n"):
            self.assertFalse([problem for problem in problems(header) if "too; give" in str(problem)])

    def test_reductions_that_are_not_counted(self):
        lines = "#include <mpi.h>\nvoid f(double& x)\n{\n  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);\n%s}\n"
        self.assert_one(self.found(packages__algebra__src__t_dot_cpp=lines % ""), "packages/algebra/src/t.cpp:4", "tellReduction() is missing")
        self.assertEqual(self.found(packages__algebra__src__t_dot_cpp=lines % "  tellReduction(8);\n"), [])


class FunctionFinder(unittest.TestCase):
    def names(self, text):
        return [(f.name, f.line, f.num_lines) for f in cpp_text.functions(textwrap.dedent(text))]

    def test_functions_in_namespaces_and_classes(self):
        text = """\
            namespace a
            {
            struct S : public T<int>
            {
              int x = 0, y{1};
              std::vector<int> v = {1, 2};
              int get() const { return x; }
            };
            enum class E { A, B };
            template <class T>
            T A::f(T t, int n = 3) const
            {
              if (t) { return {}; }
              return t;
            }
            }
            """
        self.assertEqual(self.names(text), [("get", 7, 1), ("A::f", 10, 6)])

    def test_constructor_with_initialisers(self):
        text = """\
            Log::Log(int a) noexcept : Base(a), a_{a}, b_{{1, 2}}, run_([this] { go(); })
            {
              work();
            }
            Log::~Log() {}
            """
        self.assertEqual(self.names(text), [("Log::Log", 1, 4), ("Log::~Log", 5, 1)])

    def test_braces_in_literals_comments_and_macros_do_not_count(self):
        text = '''\
            #define OPEN(x) { \\
              {
            const char* raw = R"x(int f() { " )x";
            int f() // {
            {
              char c = '{', q = '"'; /* { */
              return g("{\\"{");
            }
            int n = 1'000'000;
            int h() { return 1; }
            '''
        self.assertEqual(self.names(text), [("f", 4, 5), ("h", 10, 1)])

    def test_lines_of_a_raw_string_do_not_count(self):
        text = 'S f()\n{\n  return R"(a\n{\nb\n)";\n}\nint g() { return 1; }\n'
        self.assertEqual(self.names(text), [("f", 1, 4), ("g", 8, 1)])

    def test_signatures(self):
        text = """\
            auto f(int) -> std::vector<int> {}
            bool operator==(const A& a, const A& b) {}
            template <> inline double g<2>(double* p) {}
            const auto table = std::array{1, 2};
            const auto square = [](int x) { return x * x; };
            extern "C" { void c(struct S* s) {} }
            """
        self.assertEqual([name for name, _, _ in self.names(text)], ["f", "operator==", "g", "a function", "c"])

    def test_unbalanced_text_ends(self):
        for text in ("}", "int f() {", "namespace a {", "} int f() {}", "{{{", 'R"('):
            cpp_text.functions(text)


if __name__ == "__main__":
    unittest.main()
