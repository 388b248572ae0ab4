"""The rules that keep the house in order. Each is a function of a Tree that yields Problems; RULES lists them all."""

import dataclasses
import functools
import pathlib
import re

import cpp_text

# A package may include what stands after its arrow and, transitively, what those may include.
ARROWS = {
    "live": [],
    "base": ["live"],
    "algebra": ["base"],
    "iterative": ["algebra"],
    "krylov": ["iterative"],
    "mesh": ["base"],
    "reading": ["mesh"],
    "meshing": ["reading"],
    "fem": ["mesh"],
    "mechanics": ["fem"],
    "sampling": ["fem"],
    "assembly": ["mechanics", "algebra", "sampling"],
    "subdomain": ["assembly"],
    "cutting": ["mesh"],
    "interface": ["assembly", "cutting"],
    "coupling": ["subdomain", "interface"],
    "equilibrium": ["assembly"],
    "simd": ["equilibrium"],
    "admissibility": ["simd"],
    "flow": ["equilibrium"],
    "recovery": ["admissibility", "flow"],
    "estimation": ["recovery"],
    "adaptivity": ["algebra", "meshing"],
    "io": ["mesh", "fem", "algebra"],
    "scene": ["coupling", "meshing"],
    "condensation": ["scene"],
    "certification": ["condensation", "estimation"],
    "run": ["certification"],
    "accuracy": ["run", "adaptivity"],
    "report": ["accuracy", "io"],
    "drawing": ["assembly"],
    "driver": ["report", "iterative", "drawing"],
}

# Headers of libraries that only one folder may see. The first kind belongs to a module: nothing else may link it.
HEAVY_HOMES = {
    re.compile(r"Tpetra_|Belos|Ifpack2|Amesos2|MueLu|Kokkos|Xpetra"): ("packages/krylov/src/",),
    re.compile(r"(cholmod|[dszc]mumps_c)\.h$"): ("packages/algebra/src/",),
    re.compile(r"mpi\.h$"): ("packages/algebra/src/", "apps/ndframe/patient_waits.cpp"),
}

# Headers that take the compiler from a fifth of a second to a whole one, for every source that sees them: not in headers of packages.
SLOW_HEADERS = re.compile(r"nlohmann/|fmt/|CLI/|CGAL/|boost/|nanoflann|Teuchos_|basix/|exodusII|tinyxml2|muParser|gtest/|(iostream|regex|future)$")
SLOW_HEADERS_SEEN = {"packages/iterative/include/ndframe/iterative/krylov_library.hpp": "Teuchos_ParameterList.hpp"}

# The only source below the driver that takes a whole deck.
SETTINGS_READER = "scene_settings"

# Where solids are solved by iterations a rank has what it holds. What shows something as large as all nodes there...
OF_ALL_RANKS = re.compile(
    r"\b(?:numDofs|numNodes|rowNode|colNode|gathered|onEveryRank|onAllRanks)\(|\bsize_t\([^;]*?globalSize\(\)|\bSolverProblem\b"
)
# ... and the only files that may, and why.
MAY_SEE_ALL_RANKS = {
    "packages/iterative/src/rank_problem.cpp": "makes what a rank holds from the description of all nodes, and the way back for a direct solver",
    "packages/iterative/src/rank_problem.hpp": "the same",
    "packages/iterative/src/krylov_body.hpp": "the same: takes that description",
    "packages/iterative/src/krylov_body.cpp": "a CondensedBody takes and gives vectors of all dofs",
    "packages/iterative/src/own_dofs.cpp": "the same: a rank's part of such vectors, and the way back",
    "packages/iterative/src/own_dofs.hpp": "the same",
    "packages/iterative/src/krylov_solver.cpp": "a LinearSolver takes the description of all nodes",
    "packages/iterative/src/linear_solvers.cpp": "the same",
    "packages/iterative/src/second_choice.cpp": "the same, for a direct solver that takes over",
}

MAX_LINES = {".cpp": 300, ".hpp": 150}
MAX_PACKAGE_LINES = 6000
MAX_FUNCTION_LINES = 40
MAX_COMPARED_NAMES = 2

CODE_SUFFIXES = {".cpp", ".hpp"}
TEXT_SUFFIXES = CODE_SUFFIXES | {".py", ".cmake", ".txt", ".xml", ".json", ".sh"}
UNFINISHED = re.compile(r"\b(TO" r"DO|FIX" r"ME|XX" r"X)\b")


@dataclasses.dataclass(frozen=True)
class Problem:
    file: str
    line: int
    message: str

    def __str__(self):
        return f"{self.file}:{self.line}: {self.message}"


class SourceFile:
    def __init__(self, root, path):
        self.path = path
        self.name = str(path.relative_to(root))
        self.raw = path.read_text(errors="replace")

    @functools.cached_property
    def code(self):
        """The text without comments and literals."""
        return cpp_text.blanked(self.raw)

    @property
    def package(self):
        parts = self.name.split("/")
        return parts[1] if parts[0] == "packages" else None

    def includes(self):
        """(line, header) of every include."""
        for number, line in enumerate(self.raw.splitlines(), start=1):
            match = re.match(r'\s*#\s*include\s*[<"]([^>"]+)[>"]', line)
            if match:
                yield number, match[1]


class Tree:
    """The sources below `root`."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        files = [p for top in ("packages", "apps", "python", "tests", "cmake") for p in sorted((self.root / top).rglob("*"))]
        self.texts = [SourceFile(self.root, p) for p in files if p.is_file() and p.suffix in TEXT_SUFFIXES]
        self.code = [f for f in self.texts if f.path.suffix in CODE_SUFFIXES]
        self.product_code = [f for f in self.code if not f.name.startswith("tests/")]

    def packages(self):
        return sorted(p.name for p in (self.root / "packages").iterdir() if p.is_dir())


def line_of(text, place):
    return text.count("\n", 0, place) + 1


def reachable(package, arrows):
    """All packages that `package` may include."""
    found, waiting = set(), list(arrows.get(package, []))
    while waiting:
        following = waiting.pop()
        if following not in found:
            found.add(following)
            waiting += arrows.get(following, [])
    return found


def arrows_have_no_cycle(tree, arrows=ARROWS):
    for package in arrows:
        if package in reachable(package, arrows):
            yield Problem("tests/structure/structure_rules.py", 1, f"the arrows lead from {package} back to {package}")


def packages_are_in_the_table(tree):
    for package in tree.packages():
        if package not in ARROWS:
            yield Problem(f"packages/{package}", 1, f"package {package} has no arrows in the table of structure_rules.py")


def package_of(header):
    match = re.match(r"ndframe/([^/]+)/", header)
    return match[1] if match else None


def includes_follow_the_arrows(tree):
    for file in tree.product_code:
        allowed = reachable(file.package, ARROWS) | {file.package} if file.package else set(ARROWS)
        for line, header in file.includes():
            package = package_of(header)
            if package and package not in allowed:
                yield Problem(file.name, line, f"{file.package} may not include {package}: it is against the arrows")
            if ".." in header.split("/") or header.startswith("packages/"):
                yield Problem(file.name, line, f"{header} reaches into another folder; include \"ndframe/PACKAGE/...\"")


def headers_do_not_include_each_other(tree):
    by_header = {f.name.split("/include/")[1]: f for f in tree.product_code if "/include/" in f.name}
    graph = {name: [h for _, h in f.includes() if h in by_header] for name, f in by_header.items()}
    for name, file in by_header.items():
        if name in reachable(name, graph):
            yield Problem(file.name, 1, f"{name} includes itself through other headers")


def cmake_depends_follow_the_arrows(tree):
    for package in tree.packages():
        lists = tree.root / "packages" / package / "CMakeLists.txt"
        name = f"packages/{package}/CMakeLists.txt"
        if not lists.is_file():
            yield Problem(name, 1, "the package has no CMakeLists.txt")
            continue
        depends = cmake_depends(lists.read_text())
        for other in depends - reachable(package, ARROWS):
            yield Problem(name, 1, f"DEPENDS {other} is against the arrows")
        linked = depends.union(*(reachable(other, ARROWS) for other in depends)) | {package}
        for file in tree.product_code:
            for line, header in file.includes() if file.package == package else ():
                if package_of(header) not in linked | {None}:
                    yield Problem(file.name, line, f"{package_of(header)} is included but not among the DEPENDS of {name}")


def cmake_lists_one_source_a_line(tree):
    for package in tree.packages():
        lists = tree.root / "packages" / package / "CMakeLists.txt"
        for number, line in enumerate(lists.read_text().splitlines() if lists.is_file() else (), 1):
            if len(re.findall(r"\S+\.cpp\b", line.split("#")[0])) > 1:
                yield Problem(f"packages/{package}/CMakeLists.txt", number, "several sources on a line; one a line")


def cmake_depends(text):
    text = re.sub(r"#.*", "", text)
    match = re.search(r"ndframe_package\s*\([^)]*?\bDEPENDS\b([^)]*)", text)
    words = match[1].split() if match else []
    ends = [i for i, word in enumerate(words) if word in ("SOURCES", "LIBRARIES", "PUBLIC_LIBRARIES")]
    return set(words[: ends[0]] if ends else words)


def heavy_headers_stay_at_home(tree):
    for file in tree.code:
        for line, header in file.includes():
            for heavy, homes in HEAVY_HOMES.items():
                if heavy.match(header.split("/")[-1]) and not file.name.startswith(homes):
                    yield Problem(file.name, line, f"{header} is a heavy header; only {' and '.join(homes)} may see it")


def headers_of_packages_are_light(tree):
    for file in tree.product_code:
        if "/include/" not in file.name:
            continue
        for line, header in file.includes():
            if SLOW_HEADERS.match(header) and SLOW_HEADERS_SEEN.get(file.name) != header:
                yield Problem(file.name, line, f"{header} slows down all that include this header; include it in a source")


def decks_end_at_their_readers(tree):
    """Below the driver functions take settings that were read once, and lists only for builders of components."""
    for file in tree.product_code:
        if file.package in (None, "driver") or file.path.stem == SETTINGS_READER:
            continue
        for match in re.finditer(r"\bconst\s+Params\s*&\s*deck_?\b", file.code):
            message = f"takes the whole deck; read it in {SETTINGS_READER} and pass values"
            yield Problem(file.name, line_of(file.code, match.start()), message)


def files_are_short(tree):
    for file in tree.product_code:
        lines, limit = len(file.raw.splitlines()), MAX_LINES[file.path.suffix]
        if lines > limit:
            yield Problem(file.name, limit + 1, f"{lines} lines; a {file.path.suffix} has at most {limit}")


def packages_are_small(tree):
    for package in tree.packages():
        lines = sum(len(f.raw.splitlines()) for f in tree.product_code if f.package == package)
        if lines > MAX_PACKAGE_LINES:
            message = f"{lines} lines of sources and headers; a package has at most {MAX_PACKAGE_LINES}: cut it"
            yield Problem(f"packages/{package}", 1, message)


def functions_are_short(tree):
    for file in tree.product_code:
        for function in cpp_text.functions(file.raw):
            if function.num_lines > MAX_FUNCTION_LINES:
                yield Problem(
                    file.name,
                    function.line,
                    f"{function.name} has {function.num_lines} lines; a function has at most {MAX_FUNCTION_LINES}",
                )


def names_are_looked_up_not_compared(tree):
    comparison = re.compile(r'[=!]=\s*"[^"]*"|"[^"]*"\s*[=!]=')
    for file in tree.product_code:
        for function in cpp_text.functions(file.raw):
            found = (function.text[slice(*match.span())] for match in comparison.finditer(function.code))
            names = sorted({comparison_text.strip("=! \n") for comparison_text in found})
            if len(names) > MAX_COMPARED_NAMES:
                message = f"{function.name} compares with {', '.join(names)}; use Names<T>, a Registry or a table"
                yield Problem(file.name, function.line, message)


def what_is_thrown_is_an_exception(tree):
    """A type that does not derive from std::exception passes every handler that the program has."""
    bases = {}
    pattern = r"\b(?:class|struct)\s+(\w+)(?:\s+final)?\s*(?::\s*public\s+([\w:]+))?\s*\{"
    for file in tree.product_code:
        for match in re.finditer(pattern, file.code):
            bases.setdefault(match[1], match[2])
    for file in tree.product_code:
        for match in re.finditer(r"\bthrow\s+(\w+)\s*[({]", file.code):
            base = match[1]
            while base in bases:
                base = bases[base]
            if not (base or "").startswith("std::"):
                yield Problem(file.name, line_of(file.code, match.start()), f"{match[1]} is no std::exception")


def products_are_widened_first(tree):
    """std::size_t(a * b) overflows as int where size_t(a) * size_t(b) does not. Products of doubles show a double(."""
    for file in tree.product_code:
        for match in re.finditer(r"\bstd::(?:size_t|ptrdiff_t|int64_t)\(", file.code):
            if cpp_text.has_product(file.code, match.end()):
                message = "a product is widened too late: give each factor the wide type"
                yield Problem(file.name, line_of(file.code, match.start()), message)


def iterations_hold_their_own(tree):
    """No vector or matrix of all dofs, and no sum of one over ranks, where solids are solved by iterations."""
    for file in tree.product_code:
        if file.package not in ("iterative", "krylov"):
            continue
        match = OF_ALL_RANKS.search(file.code)
        if match and file.name not in MAY_SEE_ALL_RANKS:
            message = f"{match[0]}: as large as all ranks' nodes; take what this rank holds (RankProblem)"
            yield Problem(file.name, line_of(file.code, match.start()), message)
        if file.name in MAY_SEE_ALL_RANKS and not match:
            yield Problem(file.name, 1, "has nothing of all ranks any more: take it from MAY_SEE_ALL_RANKS")


def reductions_are_counted(tree):
    """What all ranks get from all of them is in the ledger, so that tests see how large it is."""
    for file in tree.product_code:
        reductions = list(re.finditer(r"\bMPI_I?all(?:reduce|gatherv?)\(", file.code, re.IGNORECASE))
        if file.package == "algebra" and len(reductions) > len(re.findall(r"\btellReduction\(", file.code)):
            yield Problem(file.name, line_of(file.code, reductions[-1].start()), "tellReduction() is missing: what ranks reduce is counted")


def nothing_is_unfinished(tree):
    for file in tree.texts:
        for number, line in enumerate(file.raw.splitlines(), start=1):
            match = UNFINISHED.search(line)
            if match:
                yield Problem(file.name, number, f"{match[1]}: finish it or open an issue")


def headers_are_guarded(tree):
    for file in tree.code:
        if file.path.suffix == ".hpp" and not re.search(r"^#pragma once$", file.raw, re.MULTILINE):
            yield Problem(file.name, 1, "#pragma once is missing")


def headers_are_included(tree):
    included = {header.split("/")[-1] for file in tree.code for _, header in file.includes()}
    for file in tree.code:
        if file.path.suffix == ".hpp" and file.path.name not in included:
            yield Problem(file.name, 1, "no file includes it; take it out")


def class_names_are_unique(tree):
    """Two classes of one name are one to the linker, which keeps the destructor of either."""
    known = {}
    for file in tree.product_code:
        if file.path.suffix != ".hpp" or file.package is None:
            continue
        unnamed = [m.span() for m in re.finditer(r"^namespace\n\{.*?^\} // namespace$", file.raw, re.MULTILINE | re.DOTALL)]
        for match in re.finditer(r"^(?:class|struct) (\w+)(?!\w|::|<)[^;{]*\{", file.code, re.MULTILINE):
            if any(first <= match.start() < last for first, last in unnamed):
                continue
            if match[1] in known:
                yield Problem(file.name, line_of(file.code, match.start()),
                              f"{known[match[1]]} has a class {match[1]}, too; give one another name")
            known.setdefault(match[1], file.name)


RULES = [
    arrows_have_no_cycle,
    packages_are_in_the_table,
    includes_follow_the_arrows,
    headers_do_not_include_each_other,
    cmake_depends_follow_the_arrows,
    cmake_lists_one_source_a_line,
    heavy_headers_stay_at_home,
    headers_of_packages_are_light,
    decks_end_at_their_readers,
    files_are_short,
    packages_are_small,
    functions_are_short,
    names_are_looked_up_not_compared,
    what_is_thrown_is_an_exception,
    products_are_widened_first,
    iterations_hold_their_own,
    reductions_are_counted,
    nothing_is_unfinished,
    headers_are_guarded,
    headers_are_included,
    class_names_are_unique,
]


def problems(tree):
    return [problem for rule in RULES for problem in rule(tree)]
