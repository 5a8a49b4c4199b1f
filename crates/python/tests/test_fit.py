"""Unknown numbers of a case from data in any form."""

import json

import numpy as np
import pytest
from every_call import REBOUNDS, unknown

import carom


def test_data_in_any_form_give_the_same(tmp_path):
    pandas = pytest.importorskip("pandas")
    path = tmp_path / "rebounds.csv"
    rows = zip(*REBOUNDS.values())
    path.write_text("angle (deg),body_1_tangential_ratio\n" + "".join(f"{a},{r}\n" for a, r in rows))
    frame = pandas.DataFrame(REBOUNDS)
    arrays = {name: np.array(values) for name, values in REBOUNDS.items()}
    fits = [carom.fit(unknown(), data, sd=0.014) for data in (REBOUNDS, arrays, frame, path)]
    assert all(fit == fits[0] for fit in fits)
    ratios = [-999.0 if row == 3 else value for row, value in enumerate(REBOUNDS["body_1_tangential_ratio"])]
    missing = [np.ma.masked_equal(ratios, -999.0), np.where(np.array(ratios) == -999.0, np.nan, ratios)]
    masked, nan = [carom.fit(unknown(), {**REBOUNDS, "body_1_tangential_ratio": one}, sd=0.014) for one in missing]
    assert masked == nan and masked.quality.measured_values == len(ratios) - 1
    named = carom.fit(unknown(), REBOUNDS, sd={"body_1_tangential_ratio": 0.014})
    assert named == fits[0]


def test_a_fit_gives_back_the_numbers_of_the_theory():
    angle = np.array([3.0, 7.0, 12.0, 16.0, 22.0, 28.0, 40.0, 60.0])
    r_x = carom.restitution(1.2, np.tan(np.radians(angle)) / 0.1)
    fit = carom.fit(unknown(), {"angle": angle, "R_x": r_x, "R_x_sd": 0.01 * np.ones(8)}, predict={"angle": [10.0]})
    assert fit["friction"].value == pytest.approx(0.1, abs=1e-6)
    assert fit["contact.normal_over_tangential_stiffness"].value == pytest.approx(1.2, abs=1e-5)
    assert fit.predictions.value[0] == pytest.approx(carom.restitution(1.2, np.tan(np.radians(10)) / 0.1), abs=1e-6)
    assert fit.quality.degrees_of_freedom == 6 and not fit.statements
    with pytest.raises(KeyError, match="must be one of contact.friction"):
        fit["mass"]


def test_a_wrong_value_counts_little_in_a_robust_fit():
    angle = np.array([3.0, 7.0, 12.0, 16.0, 22.0, 28.0, 40.0, 60.0])
    r_x = carom.restitution(1.2, np.tan(np.radians(angle)) / 0.1)
    r_x[4] -= 0.5
    off, robust = (
        abs(carom.fit(unknown(), {"angle": angle, "R_x": r_x}, sd=0.01, robust=word)["friction"].value - 0.1) for word in (False, True)
    )
    assert robust < 0.25 * off


def test_what_the_data_do_not_determine_is_told_and_has_no_number():
    data = {"angle": [40.0, 50.0, 60.0], "body_1_tangential_ratio": [0.779, 0.845, 0.893]}
    fit = carom.fit(unknown(), data, sd=0.014)
    assert "do not determine normal_over_tangential_stiffness" in " ".join(fit.statements)
    assert np.isnan(fit["normal_over_tangential_stiffness"].value)
    assert "do not determine" in repr(fit)


@pytest.mark.parametrize(
    "data, told",
    [
        ({"angle": [10.0, 20.0], "R_x": [0.1, np.inf]}, "column `R_x` of the data, row 2: inf must be a finite number"),
        ({"angle": [10.0, 20.0], "R_x": [0.1]}, "it has 1 rows, `angle` has 2"),
        ({"angle": [10.0], "R_x": [0.1]}, "1 measured values cannot determine 2 unknowns"),
        ({"angle": [10.0, 100.0], "R_x": [0.1, 0.2]}, r"100 must be in \[0, 90\]"),
        ({}, "there is no row"),
    ],
)
def test_wrong_data_are_told(data, told):
    with pytest.raises(ValueError, match=told):
        carom.fit(unknown(), data)


def test_what_is_no_table_is_told():
    with pytest.raises(TypeError, match="data: must be columns by name"):
        carom.fit(unknown(), 3)
    with pytest.raises(TypeError, match=r"data\['R_x'\]: must be numbers"):
        carom.fit(unknown(), {"angle": [1.0], "R_x": ["x"]})
    with pytest.raises(FileNotFoundError):
        carom.fit(unknown(), "no.csv")


def test_a_fit_is_written_as_json():
    fit = carom.fit(unknown(), REBOUNDS, sd=0.014, predict={"angle": [15.0]})
    read = json.loads(json.dumps(fit.to_dict()))
    assert read["parameters"]["value"] == fit.parameters.value.tolist()
    assert read["quality"]["degrees_of_freedom"] == fit.quality.degrees_of_freedom
    assert read["predictions"]["value"] == fit.predictions.value.tolist()


def test_what_has_no_value_is_null_in_json():
    data = {"angle": [40.0, 50.0, 60.0], "body_1_tangential_ratio": [0.779, 0.845, 0.893]}
    fit = carom.fit(unknown(), data)
    read = json.loads(json.dumps(fit.to_dict(), allow_nan=False))
    assert read["parameters"]["value"][1] is None and read["parameters"]["value"][0] == fit["friction"].value
    assert fit["friction"].to_dict()["sd"] is not None and fit["normal_over_tangential_stiffness"].to_dict()["sd"] is None


def test_errors_have_the_unit_of_their_column():
    angle, slip = [30.0, 34.0, 39.0, 45.0], np.array([1.1, 1.32, 1.57, 1.88])
    metres = carom.fit(unknown(), {"angle": angle, "slip_after": slip}, sd=0.03)
    data = {"angle": angle, "slip_after (mm/s)": 1e3 * slip}
    for sd in (30.0, {"slip_after": 30.0}, {"slip_after (mm/s)": [30.0] * 4}, {"slip_after (m/s)": 0.03}):
        assert carom.fit(unknown(), data, sd=sd)["friction"].sd == pytest.approx(metres["friction"].sd, rel=1e-9)
    with pytest.raises(ValueError, match="given twice, as `sd` and by the column `slip_after_sd`"):
        carom.fit(unknown(), data | {"slip_after_sd": [30.0] * 4}, sd=30.0)


def test_each_row_may_have_its_own_error():
    count = len(REBOUNDS["angle"])
    one = carom.fit(unknown(), REBOUNDS, sd=0.014)
    assert carom.fit(unknown(), REBOUNDS, sd=np.full(count, 0.014)) == one
    assert carom.fit(unknown(), REBOUNDS, sd={"body_1_tangential_ratio": [0.014] * count}) == one
    assert carom.fit(unknown(), REBOUNDS, sd=np.linspace(0.01, 0.03, count)) != one
    with pytest.raises(ValueError, match="2 standard errors are given for"):
        carom.fit(unknown(), REBOUNDS, sd=[0.1, 0.2])
