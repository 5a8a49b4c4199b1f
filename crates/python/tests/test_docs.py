"""The examples of the documentation, and the files that are made from the tables of columns."""

import doctest
import importlib
import pathlib
import re
import subprocess
import sys
import warnings

import carom
import pytest

MODULES = ["carom", "carom.special", "carom._contact_theory", "carom._contacts", "carom._creep", "carom._grains", "carom._impact", "carom._mesh", "carom._roll", "carom._solver", "carom.cases", "carom.plot"]


@pytest.mark.parametrize("name", MODULES)
def test_examples_run(name):
    module = importlib.import_module(name)
    with warnings.catch_warnings():
        warnings.simplefilter("error", carom.CaromWarning)
        results = doctest.testmod(module, optionflags=doctest.IGNORE_EXCEPTION_DETAIL | doctest.ELLIPSIS)
    assert results.attempted > 0
    assert results.failed == 0


def shown(page):
    """Runs the examples of a page, which warn of nothing but what it shows."""
    text = page.read_text(encoding="utf-8")
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        results = doctest.testfile(str(page), module_relative=False)
    words = " ".join(text.split())
    for line in [line for warning in told for line in str(warning.message).splitlines()]:
        # Up to its first number, which may differ in a digit elsewhere.
        assert re.split(r"\d", line)[0].strip() in words, f"{page.name} does not show: {line}"
    assert results.failed == 0
    return results.attempted


def test_a_warning_that_a_page_does_not_show_is_found(tmp_path):
    page = tmp_path / "page.md"
    page.write_text(">>> import warnings\n>>> warnings.warn('the ball ' + 'yields')\n\n")
    with pytest.raises(AssertionError, match="does not show: the ball yields"):
        shown(page)
    page.write_text(page.read_text() + "It warns that\nthe ball\nyields.\n")
    assert shown(page) == 2


@pytest.mark.parametrize(
    ("page", "least"),
    [("crates/python/README.md", 20), ("docs/book/src/start/python.md", 10), ("docs/book/src/tasks/rail.md", 4)],
)
def test_examples_of_the_pages_run(monkeypatch, page, least):
    if page.endswith("start/python.md"):
        pytest.importorskip("matplotlib").use("Agg")
    root = pathlib.Path(__file__).parents[3]
    monkeypatch.chdir(root)
    assert shown(root / page) > least


def test_result_classes_are_current():
    """Else: cargo xtask generate"""
    from carom import _make_records, _records

    assert pathlib.Path(_records.__file__).read_text(encoding="utf-8") == _make_records.made()


def test_results_tell_their_units():
    assert carom.HertzState.units["peak_pressure"] == "Pa"
    assert "peak_pressure" in carom.HertzState.__doc__
    assert carom.HistoryPoint.units["F"] == "N"


def test_everything_public_is_documented():
    for name in carom.__all__:
        thing = getattr(carom, name)
        if callable(thing):
            assert thing.__doc__, name
            for member, value in vars(thing).items() if isinstance(thing, type) else []:
                if not member.startswith("_") and callable(value):
                    assert value.__doc__, f"{name}.{member}"


def test_module_is_installed_and_typed():
    folder = pathlib.Path(carom.__file__).parent
    assert "site-packages" in folder.parts
    assert (folder / "py.typed").exists()


def test_the_import_takes_only_itself_and_numpy():
    """What is imported beyond numpy is seen, not timed: carom's own modules and three small ones."""
    code = "import sys, numpy; before = set(sys.modules); import carom; print(*set(sys.modules) - before)"
    names = subprocess.check_output([sys.executable, "-c", code], text=True).split()
    others = {name for name in names if name.partition(".")[0] != "carom"}
    assert others <= {"__future__", "copy", "dataclasses", "numpy.typing", "numpy._typing._add_docstring"}


def test_types_of_the_native_part_are_all_there():
    """Each name of the stub is in the module, and each of the module in the stub, members too."""
    import ast

    from carom import _carom

    def public(names):
        return {name for name in names if not name.startswith("_")}

    stub = pathlib.Path(_carom.__file__).parent / "_carom.pyi"
    tree = ast.parse(stub.read_text(encoding="utf-8"))
    kinds = (ast.ClassDef, ast.FunctionDef)
    named = {node.name: node for node in tree.body if isinstance(node, kinds)}
    assert set(named) == public(vars(_carom))
    for name, node in named.items():
        if isinstance(node, ast.ClassDef) and not issubclass(getattr(_carom, name), Exception):
            members = {member.name for member in node.body if isinstance(member, ast.FunctionDef)}
            assert public(members) == public(vars(getattr(_carom, name))), name
