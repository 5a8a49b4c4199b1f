"""The schemas of case files in `docs/schema`, by the validator that others use."""

import json
import sys
from pathlib import Path

import pytest

jsonschema = pytest.importorskip("jsonschema")
if sys.version_info >= (3, 11):
    import tomllib
else:
    tomllib = pytest.importorskip("tomli")

ROOT = Path(__file__).parents[3]
EXAMPLES = ROOT / "examples"
MISTAKES = ROOT / "crates/cli/tests/it/schema/mistakes.toml"
KINDS = sorted(path.stem for path in (ROOT / "docs/schema").glob("*.json"))
VALIDATOR = jsonschema.Draft4Validator


def validator(kind):
    schema = json.loads((ROOT / f"docs/schema/{kind}.json").read_text(encoding="utf-8"))
    VALIDATOR.check_schema(schema)
    return VALIDATOR(schema)


def kind_of(name):
    """The kind of an example; impacts are not named after it."""
    kind = name.split("_")[0]
    return kind if kind in KINDS else "impact"


@pytest.mark.parametrize("kind", KINDS)
def test_every_example_is_valid(kind):
    schema = validator(kind)
    paths = [path for path in EXAMPLES.glob("*.toml") if kind_of(path.name) == kind]
    assert paths
    for path in paths:
        case = tomllib.loads(path.read_text(encoding="utf-8"))
        faults = [f"{list(fault.path)}: {fault.message}" for fault in schema.iter_errors(case)]
        assert not faults, path.name


MISTAKEN = tomllib.loads(MISTAKES.read_text(encoding="utf-8"))["mistake"]


@pytest.mark.parametrize("mistake", MISTAKEN, ids=lambda mistake: mistake["what"])
def test_a_mistake_is_no_valid_case(mistake):
    source = (EXAMPLES / mistake["example"]).read_text(encoding="utf-8")
    wrong = source.replace(mistake["old"], mistake["new"], 1)
    assert wrong != source
    assert not validator(kind_of(mistake["example"])).is_valid(tomllib.loads(wrong))
