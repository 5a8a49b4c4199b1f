"""Type checkers accept the package and the code of its users, and find the types that users expect."""

import doctest
import json
import pathlib
import subprocess
import sys

import pytest

HERE = pathlib.Path(__file__).parent
PROJECT = HERE.parent
BOOK = [HERE.parents[2] / "docs/book/src" / page for page in ("start/python.md", "tasks/rail.md")]


def run(folder, *command):
    done = subprocess.run([sys.executable, "-m", *command], capture_output=True, text=True, cwd=folder)
    return done.stdout + done.stderr


@pytest.fixture(scope="module")
def mypy(tmp_path_factory):
    """What mypy says in its strictest form of code in a folder. What it has found out about other packages it keeps
    for the next test."""
    pytest.importorskip("mypy")
    kept = str(tmp_path_factory.mktemp("mypy"))
    return lambda folder, *what: run(folder, "mypy", "--strict", "--no-error-summary", "--cache-dir", kept, *what)


def pyright(folder):
    """The errors that pyright finds in the programs of a folder."""
    pytest.importorskip("pyright")
    (folder / "pyrightconfig.json").write_text('{"typeCheckingMode": "standard"}')
    told = run(folder, "pyright", "--outputjson", "--pythonpath", sys.executable)
    found = json.loads(told[told.index("{") :])["generalDiagnostics"]
    errors = (one for one in found if one["severity"] == "error")
    return "\n".join(f"{one['file']}:{one['range']['start']['line'] + 1}: {one['message']}" for one in errors)


def code_of(page):
    """The examples of a page as one program."""
    text = page.read_text(encoding="utf-8")
    if page.suffix == ".ipynb":
        cells = json.loads(text)["cells"]
        lines = [line for cell in cells if cell["cell_type"] == "code" for line in (*cell["source"], "\n")]
        return "".join(line for line in lines if not line.startswith("%"))
    return "\n".join(example.source for example in doctest.DocTestParser().get_examples(text))


PAGES = [HERE / "typed.py", PROJECT / "README.md", *BOOK, *sorted((PROJECT / "examples").glob("*.ipynb"))]


@pytest.fixture(scope="module")
def programs(tmp_path_factory):
    """A folder with the code of all pages."""
    folder = tmp_path_factory.mktemp("programs")
    for page in PAGES:
        code = page.read_text(encoding="utf-8") if page.suffix == ".py" else code_of(page)
        (folder / f"{page.stem}_.py").write_text(code, encoding="utf-8")
    return folder


def test_user_code_passes_mypy_in_its_strictest_form(programs, mypy):
    assert mypy(programs, *(path.name for path in programs.glob("*.py"))) == ""


def test_user_code_passes_pyright(programs):
    assert pyright(programs) == ""


def test_a_wrong_type_is_found(tmp_path, mypy):
    (tmp_path / "wrong.py").write_text(
        "import carom\nx: str = carom.restitution(1.2, 1.0)\ny: float = carom.special.k([1.0])\n"
    )
    for says in (mypy(tmp_path, "wrong.py"), pyright(tmp_path)):
        assert "wrong.py:2:" in says and "wrong.py:3:" in says, says


def test_the_package_passes_mypy_in_its_strictest_form(tmp_path, mypy):
    assert mypy(tmp_path, "-p", "carom") == ""


def test_the_user_code_runs():
    pytest.importorskip("typing_extensions")
    code = compile((HERE / "typed.py").read_text(encoding="utf-8"), str(HERE / "typed.py"), "exec")
    exec(code, {"__file__": str(HERE / "typed.py"), "__name__": "typed"})
