"""Unlike bodies, oblong cells and grids: each number in its own place."""

import carom
import numpy as np
import pytest


def ball(nx, ny, size, pair, friction, radii):
    """A solver of a paraboloid with these relative radii, on cells that are not square."""
    x, y = carom.cells((ny, nx), size=size)
    gap = x**2 / (2 * radii[0]) + y**2 / (2 * radii[1])
    return carom.Solver(gap, size, pair, friction), x, y


def test_stress_below_unlike_bodies_is_hubers_with_the_poissons_ratio_of_each():
    soft, stiff = carom.Material(2e9, 0.05), carom.Material(5e9, 0.45)
    solver, *_ = ball(65, 65, (2.2e-3, 2.2e-3), carom.MaterialPair(soft, stiff), 0.0, (0.05, 0.05))
    solver.step(zeta=1e-5)
    a, depth = np.sqrt(0.05 * 1e-5), np.array([0.25, 0.5, 1.0, 1.5])
    zeros = np.zeros(4)
    modulus = 1 / ((1 - 0.05**2) / 2e9 + (1 - 0.45**2) / 5e9)
    peak = 2 * modulus * a / (np.pi * 0.05)  # 2 E* a/(pi R)
    for body, sign, nu in ((1, 1, 0.05), (2, -1, 0.45)):
        stress = solver.stress(zeros, zeros, sign * depth * a, body=body)
        across = -(1 + nu) * (1 - depth * np.arctan(1 / depth)) + 0.5 / (1 + depth**2)
        expected = np.stack([across, across, -1 / (1 + depth**2), zeros, zeros, zeros], axis=1)
        assert np.allclose(stress / peak, expected, atol=0.02), (body, stress / peak, expected)
        # Beside the axis the shear lies in the plane through it: zx on x, yz on y.
        beside = solver.stress([0.6 * a, 0.0], [0.0, 0.6 * a], sign * 0.5 * a, body=body) / peak
        assert abs(beside[0, 5]) > 0.05 > 1e3 * abs(beside[0, 4])
        assert abs(beside[1, 4]) > 0.05 > 1e3 * abs(beside[1, 5])


@pytest.mark.parametrize("nx, ny, size", [(60, 24, (1.5e-3, 1.4e-3)), (26, 50, (1.5e-3, 1.3e-3))])
def test_a_contact_on_oblong_cells_is_that_of_hertz_and_mindlin(nx, ny, size):
    material = carom.Material(2e9, 0.3)
    pair = carom.MaterialPair(material, material)
    solver, x, y = ball(nx, ny, size, pair, 0.5, (0.02, 0.02))
    pressed = solver.step(zeta=1e-5)
    modulus, a = 2e9 / 2 / (1 - 0.3**2), np.sqrt(0.02 * 1e-5)
    force = 4 / 3 * modulus * a * 1e-5
    assert abs(pressed.F_z / force - 1) < 0.02
    assert abs(pressed.contact_area / (np.pi * a**2) - 1) < 0.08
    cell = size[0] / nx * size[1] / ny
    assert np.isclose(solver.pressure.sum() * cell, pressed.F_z)
    # The second moments along both axes are those of Hertz's pressure, F a^2/5.
    for at in (x, y):
        assert abs((solver.pressure * at**2).sum() * cell / (pressed.F_z * a**2 / 5) - 1) < 0.03
    # Cattaneo and Mindlin: xi = (3 f F_z/(16 a G*)) (2 - nu) (1 - (1 - F_x/(f F_z))^(2/3)), G* = G/2.
    moved = solver.step(xi=1e-6, eta=0.0)
    shear = 2e9 / (2 * 1.3)
    limit = 0.5 * pressed.F_z
    expected = 3 * limit * (2 - 0.3) / (8 * shear * a) * (1 - (1 - moved.F_x / limit) ** (2 / 3))
    assert abs(expected / 1e-6 - 1) < 0.03
    turned = solver.step(xi=0.0, eta=1e-6)
    assert turned.F_y > 0.9 * moved.F_x


def test_motions_that_are_not_given_are_those_of_the_bodies():
    steel, glass = carom.Material(208e9, 0.3), carom.Material(70e9, 0.2)
    one = carom.sphere(0.01, steel, 0.03, velocity=(1.0, 0.3, -2.0), spin=(20.0, -30.0, 5.0))
    two = carom.sphere(0.02, glass, 0.05, velocity=(0.2, -0.1, 0.5), spin=(-40.0, 10.0, 7.0))
    once = carom.collide(one, two, 0.2)
    motions = {name: getattr(body, name.split("_")[-1]) for name, body in
               (("body_1_velocity", one), ("body_1_spin", one), ("body_2_velocity", two), ("body_2_spin", two))}
    fields = ("body_1_velocity", "body_1_spin", "body_2_velocity", "body_2_spin", "energy_before", "energy_dissipated")
    for left_out in (*motions, None):
        given = {name: v for name, v in motions.items() if name != left_out}
        for chosen in (given, {}):
            many = carom.collide_many(one, two, [0.2], **chosen)
            for name in fields:
                got, expected = getattr(many, name)[0], getattr(once, name)
                assert np.array_equal(got, expected), (left_out, name)
    # And each that is given counts for its own body: momentum and energy before are those of the motions.
    for i, name in enumerate(motions):
        changed = {name: np.asarray(motions[name]) + (0.3, -0.2, 0.1)}
        many = carom.collide_many(one, two, [0.2], **changed)
        now = {**motions, **changed}
        energy = sum(
            0.5 * m * np.dot(now[f"body_{k}_velocity"], now[f"body_{k}_velocity"])
            + 0.5 * (0.4 * m * r**2) * np.dot(now[f"body_{k}_spin"], now[f"body_{k}_spin"])
            for k, m, r in ((1, 0.03, 0.01), (2, 0.05, 0.02))
        )
        assert np.isclose(many.energy_before[0], energy, rtol=1e-12), (i, name)
        before = sum(m * np.asarray(now[f"body_{k}_velocity"]) for k, m in ((1, 0.03), (2, 0.05)))
        after = 0.03 * many.body_1_velocity[0] + 0.05 * many.body_2_velocity[0]
        assert np.allclose(before, after, rtol=1e-12)


def test_fields_of_a_solved_case_have_y_first(tmp_path):
    path = tmp_path / "oblong.toml"
    path.write_text("""
[body_1]
material = { shear_modulus = "1 MPa", poisson = 0.5 }
[body_2]
material = { rigid = true }
[gap]
shape = "polygon"
corners = [[-1.2e-3, -0.3e-3], [1.2e-3, -0.3e-3], [1.2e-3, 0.6e-3], [-1.2e-3, 0.6e-3]]
[grid]
cells = [40, 18]
size = ["4 mm", "1.8 mm"]
[contact]
friction = 0.3
[[step]]
F_z = 0.1
[[step]]
F_x = 0.01
F_y = -0.005
""")
    solved = carom.cases.solve(path)
    assert solved.x.shape == (40,) and solved.y.shape == (18,)
    cell = (solved.x[1] - solved.x[0]) * (solved.y[1] - solved.y[0])
    assert np.isclose(cell, 1e-8)
    under = (np.abs(solved.x) < 1.2e-3) & (np.abs(solved.y - 0.15e-3) < 0.45e-3)[:, None]
    assert np.array_equal(solved.cells > 0, under)
    assert np.array_equal(solved.pressure > 0, under)
    sums = {"F_z": solved.pressure, "F_x": solved.traction_x, "F_y": solved.traction_y}
    for name, field in sums.items():
        assert field.shape == (18, 40)
        assert np.isclose(field.sum() * cell, getattr(solved.steps, name)[-1], rtol=1e-6)
    torque = (solved.y[:, None] * solved.traction_x - solved.x * solved.traction_y).sum() * cell
    assert np.isclose(torque, solved.steps.M_z[-1], rtol=1e-6)
    # Symmetric about the punch's own middle: the pressures' too.
    assert abs((solved.pressure * solved.x).sum()) < 1e-9 * solved.pressure.sum()
    assert abs((solved.pressure * solved.y[:, None]).sum() / solved.pressure.sum() - 0.15e-3) < 1e-9
    for field in (solved.displacement_x, solved.displacement_y):
        assert field.shape == (18, 40)
    # What sticks has moved as one, along x with F_x.
    stuck = solved.cells == 1
    assert np.ptp(solved.displacement_x[stuck]) < 1e-6 * np.abs(solved.displacement_x).max()
    assert solved.displacement_x[stuck].mean() * 0.01 > 0 > solved.displacement_y[stuck].mean() * 0.005


def test_the_impact_of_a_case_is_one_and_that_of_a_sweep_as_many_as_it_has(tmp_path):
    path = tmp_path / "ball.toml"
    once = carom.cases.new("impact")
    path.write_text(once)
    rebound = carom.cases.impact(path)
    assert isinstance(rebound.R_x, float) and rebound.body_1_velocity.shape == (3,)
    path.write_text(once.replace("friction = 0.2", "friction = [0.1, 0.2, 0.3]"))
    swept = carom.cases.impact(path)
    assert swept.R_x.shape == (3,) and swept.R_x[1] == rebound.R_x
    assert np.array_equal(swept.body_1_velocity[1], rebound.body_1_velocity)


@pytest.mark.parametrize("side, x, y", [("left", -1, 0), ("right", 1, 0), ("lower", 0, -1), ("upper", 0, 1)])
def test_a_contact_that_reaches_a_border_names_its_side(tmp_path, side, x, y):
    path = tmp_path / "border.toml"
    corners = [[u + 0.7e-3 * x, v + 0.7e-3 * y] for u, v in
               ((-4e-4, -4e-4), (4e-4, -4e-4), (4e-4, 4e-4), (-4e-4, 4e-4))]
    path.write_text(f"""
[body_1]
material = {{ shear_modulus = "1 MPa", poisson = 0.5 }}
[body_2]
material = {{ rigid = true }}
[gap]
shape = "polygon"
corners = {corners}
[grid]
cells = [20, 20]
size = ["2 mm", "2 mm"]
[contact]
friction = 0.3
[[step]]
F_z = 0.01
""")
    with pytest.raises(Exception, match=side):
        carom.cases.solve(path)
