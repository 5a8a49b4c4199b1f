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

import carom

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
    paths = [*EXAMPLES.glob("*.toml"), *EXAMPLES.glob("fit/*.toml")]
    paths = [path for path in paths if kind_of(path.name) == kind]
    assert paths
    for path in paths:
        case = tomllib.loads(path.read_text(encoding="utf-8"))
        faults = [f"{list(fault.path)}: {fault.message}" for fault in schema.iter_errors(case)]
        assert not faults, path.name


@pytest.mark.parametrize("kind", KINDS)
def test_a_new_case_is_valid(kind):
    faults = validator(kind).iter_errors(tomllib.loads(carom.cases.new(kind)))
    assert not [fault.message for fault in faults]


RIGHT = {
    "PositiveLength": ["10 mm", "1e3m", ".5 m", "5. µm", "5 μm", " 2E-3 km ", "+1 nm"],
    "PositiveDensity": ["7.85 g/cm^3", "7.85 g/cm³", "7850 kg/m3"],
    "SpeedSpin": ["3000 rpm", "-180 deg/s", "180 °/s", "2 1/min"],
    "PositiveOrInfiniteInertia": ["12 g·cm²", "12 g cm^2", "12 g*cm2", "inf", "inf kg m2"],
    "IncidenceDegrees": ["30°", "0 rad"],
    "Friction": ["inf", "+inf"],
    "RadiusLength": ["-inf", "-3 mm"],
}
WRONG = {
    "PositiveLength": ["10", "10 mm2", "mm", "1e m", "10 MM", "- 1 m", "0 m", "inf", "1 m m"],
    "SpeedSpin": ["3 rad", "inf rad/s"],
    "IncidenceDegrees": ["-30°", "30 °C"],
    "Friction": ["0.3", "-inf", "nan"],
    "RadiusLength": ["0 mm"],
}


def test_texts_with_units_are_those_of_the_reader():
    schemas = [validator(kind).schema["definitions"] for kind in KINDS]
    for is_right, all_texts in [(True, RIGHT), (False, WRONG)]:
        for name, texts in all_texts.items():
            definitions = [schema[name] for schema in schemas if name in schema]
            assert definitions, name
            for definition in definitions:
                for text in texts:
                    assert VALIDATOR(definition).is_valid(text) == is_right, (name, text)


MISTAKEN = tomllib.loads(MISTAKES.read_text(encoding="utf-8"))["mistake"]


@pytest.mark.parametrize("mistake", MISTAKEN, ids=lambda mistake: mistake["what"])
def test_a_mistake_is_no_valid_case(mistake):
    source = (EXAMPLES / mistake["example"]).read_text(encoding="utf-8")
    wrong = source.replace(mistake["old"], mistake["new"], 1)
    assert wrong != source
    assert not validator(kind_of(mistake["example"])).is_valid(tomllib.loads(wrong))
