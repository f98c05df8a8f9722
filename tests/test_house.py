"""The rules of the house: who may import what, how long a module is, what commands and values say of themselves."""

import ast
import re
import sys
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.metadata import entry_points
from pathlib import Path
from typing import TypeGuard

import pytest

ROOT = Path(__file__).parents[1]
PACKAGES = ("captra", "export", "service", "clients")
PYPROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
COMMANDS = PYPROJECT["project"]["entry-points"]["captra.commands"]
LONGEST_MODULE = 400

SEES: dict[str, set[str]] = {
    "captra": {"captra"},
    "export": {"captra", "export"},
    "service": {"captra", "service"},
    "clients": {"captra", "clients"},
}
"""Imports run downwards only."""

CORE_NEEDS = {"numpy", "numba", "jaxtyping"}
CONSOLE = {"captra/cli.py", "captra/__main__.py"}
ONLY_IN: dict[str, tuple[str, ...]] = {
    "torch": ("captra/learn/", "export/"),
    "onnx": ("export/", "captra/learn/from_bundle.py"),
    "onnxruntime": ("captra/runtime/", "captra/bench/"),
    "trimesh": ("captra/data/", "captra/learn/"),
    "embreex": ("captra/data/",),
    "fastapi": ("service/",),
    "httpx": ("clients/",),
}
"""Heavy dependencies stay where they belong, so that the served image needs only its own."""
LAZY = {"torch": ("captra/learn/", "export/"), "onnxruntime": (), "matplotlib": ()}
"""Imported inside functions, but for the folders named."""

MACHINE_PATH = re.compile(r"(?<![\w.])/(?:home|root|work|Users)/\w+")


@dataclass(frozen=True)
class Import:
    """One imported module."""

    name: str
    """With all its dots."""
    at_top: bool
    """Whether it is imported with the module rather than inside a function."""

    @property
    def package(self) -> str:
        """Its first part."""
        return self.name.partition(".")[0]


def modules(*folders: str) -> list[str]:
    """Paths of Python files below some folders, relative to the root."""
    files = (path for folder in folders for path in (ROOT / folder).rglob("*.py"))
    return sorted(path.relative_to(ROOT).as_posix() for path in files)


def imports(tree: ast.AST, *, at_top: bool = True) -> Iterator[Import]:
    """Everything that a module imports, wherever it does."""
    for node in ast.iter_child_nodes(tree):
        match node:
            case ast.Import(names=names):
                yield from (Import(alias.name, at_top) for alias in names)
            case ast.ImportFrom(module=str(module), names=names, level=0):
                yield from (Import(f"{module}.{alias.name}", at_top) for alias in names)
            case ast.FunctionDef() | ast.AsyncFunctionDef():
                yield from imports(node, at_top=False)
            case _:
                yield from imports(node, at_top=at_top)


def imported(*folders: str) -> Iterator[tuple[str, Import]]:
    """Every module with everything that it imports."""
    for module in modules(*folders):
        for each in imports(ast.parse((ROOT / module).read_text())):
            yield module, each


def is_value(node: ast.AST) -> TypeGuard[ast.ClassDef]:
    """Whether this is a public frozen dataclass."""
    if not isinstance(node, ast.ClassDef) or node.name.startswith("_"):
        return False
    return any("frozen=True" in ast.unparse(decorator) for decorator in node.decorator_list)


def is_public_field(node: ast.AST) -> bool:
    """Whether this is an annotated name that is neither private nor shared by all instances."""
    text = ast.unparse(node)
    return isinstance(node, ast.AnnAssign) and "ClassVar" not in text and not text.startswith("_")


def undescribed_fields(module: str) -> Iterator[str]:
    """Public fields of frozen dataclasses that no docstring follows."""
    for value in filter(is_value, ast.walk(ast.parse((ROOT / module).read_text()))):
        for field, after in zip(value.body, [*value.body[1:], ast.Pass()], strict=True):
            if is_public_field(field) and not (isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant)):
                yield f"{module}: {value.name}.{ast.unparse(field)}"


def test_imports_run_downwards() -> None:
    ours = {*PACKAGES, "tests", "benchmarks"}
    upwards = [
        (module, each.name)
        for module, each in imported(*PACKAGES)
        if each.package in ours and each.package not in SEES[module.partition("/")[0]]
    ]
    assert upwards == []


def test_the_core_needs_numpy_and_the_kernels_only() -> None:
    allowed = CORE_NEEDS | set(sys.stdlib_module_names)
    core = [(module, each) for module, each in imported("captra") if module.count("/") == 1 and module not in CONSOLE]
    assert len({module for module, _ in core}) > 5
    foreign = [(module, each.name) for module, each in core if each.package not in {"captra", *allowed}]
    deeper = [
        (module, each.name)
        for module, each in core
        if each.package == "captra" and (ROOT / "captra" / each.name.split(".")[1]).is_dir()
    ]
    assert foreign + deeper == []


def test_heavy_dependencies_stay_where_they_belong() -> None:
    misplaced = [
        (module, each.name)
        for module, each in imported(*PACKAGES)
        if not module.startswith(ONLY_IN.get(each.package, ("",)))
    ]
    assert misplaced == []


def test_heavy_dependencies_are_imported_when_they_are_needed() -> None:
    eager = [
        (module, each.name)
        for module, each in imported(*PACKAGES)
        if each.at_top and each.package in LAZY and not module.startswith(LAZY[each.package])
    ]
    assert eager == []


def test_what_is_served_does_not_lead_to_pytorch() -> None:
    led = [
        (module, each.name)
        for module, each in imported("captra/runtime", "service", "clients")
        if each.name.startswith("captra.learn")
    ]
    assert led == []


def test_modules_are_short() -> None:
    lengths = {name: len((ROOT / name).read_text().splitlines()) for name in modules(*PACKAGES, "tests", "benchmarks")}
    assert {name: length for name, length in lengths.items() if length > LONGEST_MODULE} == {}


def test_every_field_of_a_value_is_described() -> None:
    assert [field for module in modules(*PACKAGES) for field in undescribed_fields(module)] == []


def test_no_path_of_one_machine() -> None:
    paths = [*modules(*PACKAGES, "tests", "benchmarks"), "Makefile", "README.md", "pyproject.toml", ".ci/run"]
    found = {path: MACHINE_PATH.findall((ROOT / path).read_text()) for path in paths}
    assert {path: matches for path, matches in found.items() if matches} == {}


def test_the_installed_commands_are_those_of_pyproject() -> None:
    installed = {entry.name: entry.value for entry in entry_points(group="captra.commands")}
    assert installed == COMMANDS, "run `make venv`"


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_shows_an_example(name: str) -> None:
    (command,) = (entry.load() for entry in entry_points(group="captra.commands", name=name))
    example = re.search(r"Example:\s+`?(captra [\w-]+)", command.__doc__ or "")
    assert example is not None, f"the docstring of {name} has no example"
    assert example[1] == f"captra {name}"
