"""Writes reference.json: random oblique impacts, each computed by the library carom without its table.

Needs the Python module `carom` and NumPy: python tests/make_reference.py
"""

import json
import pathlib
import sys

import carom
import numpy as np

SEED = 20261125
HEAD = (
    "Made by tests/make_reference.py, seed %d: oblique impacts of like materials by carom.collide "
    "(law='coulomb', torsion=False), which follows each impact from first contact to separation; R_x of `groups` by "
    "carom.restitution_of_groups (exact=True). SI units; body2 null is a fixed plane."
)
# Kinds of impact by psi: how far it sticks, on which side of the border to gross sliding, psi = chi (1 + e) - e, it lies.
KINDS = {
    "sticking": lambda r, chi, end: 10 ** r.uniform(-4, -1),
    "partial slip": lambda r, chi, end: r.uniform(0.1, 1),
    "sticking ends": lambda r, chi, end: 1 + r.choice([-1, 1]) * 10 ** r.uniform(-8, -1),
    "slides first": lambda r, chi, end: r.uniform(1, end),
    "border": lambda r, chi, end: end * (1 + r.choice([-1, 1]) * 10 ** r.uniform(-8, -1)),
    "sliding": lambda r, chi, end: end * 10 ** r.uniform(0, 2),
}
EACH = 80
GROUPS = 200


def direction(random):
    vector = random.normal(size=3)
    return vector / np.linalg.norm(vector)


def body(random):
    # Solid, a thin shell, or between.
    inertia = random.choice([0.4, 2 / 3, random.uniform(0.35, 2 / 3)], p=[0.5, 0.25, 0.25])
    return {
        "mass": 10 ** random.uniform(-4, 1),
        "radius": 10 ** random.uniform(-3, 0),
        "inertia": float(inertia),
        "velocity": (3 * random.normal(size=3)).tolist(),
        "spin": None,
    }


def spun(random, one):
    one["spin"] = (direction(random) * random.uniform(0, 2) / one["radius"]).tolist()


def contact_velocity(one, normal, side):
    return np.array(one["velocity"]) + np.cross(one["spin"], side * one["radius"] * normal)


def shift(one, by):
    one["velocity"] = (np.array(one["velocity"]) + by).tolist()


def case(random, kind):
    normal = direction(random)
    bodies = [body(random)] if random.random() < 0.4 else [body(random), body(random)]
    for one in bodies:
        spun(random, one)
    poisson = random.choice([0.0, 0.3, 0.5, random.uniform(-0.5, 0.5)])
    friction = 10 ** random.uniform(-2, 0.3)
    # The groups and, by the velocity of body 1, the wanted approach and slip.
    kappa = (2 - poisson) / (2 * (1 - poisson))
    ratio = sum((1 + 1 / one["inertia"]) / one["mass"] for one in bodies) / sum(1 / one["mass"] for one in bodies)
    chi = ratio / kappa
    restitution = random.choice([1.0, float(random.uniform(0.1, 1))])
    psi = KINDS[kind](random, chi, chi * (1 + restitution) - restitution)
    approach = 10 ** random.uniform(-2, 1)
    tangent = np.cross(normal, direction(random))
    tangent /= np.linalg.norm(tangent)
    wanted = approach * normal + psi * kappa * friction * approach * tangent
    relative = -contact_velocity(bodies[0], normal, -1)
    if len(bodies) == 2:
        relative = relative + contact_velocity(bodies[1], normal, 1)
    shift(bodies[0], relative - wanted)
    return {
        "kind": kind,
        "body1": bodies[0],
        "body2": bodies[1] if len(bodies) == 2 else None,
        "normal": normal.tolist(),
        "poisson": float(poisson),
        "friction": float(friction),
        "restitution": float(restitution),
    }


def solved(given):
    # Stiff and large against the deformation, since only the ratio of stiffnesses counts: no line of centres turns.
    material = carom.Material(1e22, given["poisson"])

    def made(one):
        moment = one["inertia"] * one["mass"] * one["radius"] ** 2
        return carom.Body(
            "sphere", [one["radius"]], material, one["mass"], moments=[moment] * 3,
            velocity=one["velocity"], spin=one["spin"],
        )

    bodies = [made(given["body1"]), made(given["body2"]) if given["body2"] else carom.plane(material)]
    rebound = carom.collide(
        *bodies, given["friction"], normal=given["normal"], law="coulomb", torsion=False,
        normal_restitution=given["restitution"], tolerance=1e-6 if given["restitution"] < 1 else None,
    )
    count = 2 if given["body2"] else 1
    return {
        "rx": float(rebound.R_x),
        "velocities": [list(map(float, v)) for v in (rebound.body_1_velocity, rebound.body_2_velocity)[:count]],
        "spins": [list(map(float, v)) for v in (rebound.body_1_spin, rebound.body_2_spin)[:count]],
    }


def main():
    import warnings

    warnings.simplefilter("ignore", carom.CaromWarning)
    random = np.random.default_rng(SEED)
    cases = []
    for kind in KINDS:
        for _ in range(EACH):
            given = case(random, kind)
            cases.append({"given": given, "after": solved(given)})
    chi = random.uniform(1, 5.25, GROUPS)
    psi = random.uniform(0, 1.05, GROUPS) * (2 * chi - 1)
    exact = carom.restitution_of_groups(chi, psi, exact=True)
    groups = [list(map(float, row)) for row in zip(chi, psi, exact, strict=True)]
    lines = lambda rows: ",\n".join(json.dumps(row) for row in rows)
    text = (
        f'{{"made": {json.dumps(HEAD % SEED)},\n"carom": "{carom.__version__}",\n'
        f'"groups": [\n{lines(groups)}\n],\n"cases": [\n{lines(cases)}\n]}}\n'
    )
    pathlib.Path(__file__).with_name("reference.json").write_text(text)
    print(f"{len(cases)} impacts, {len(groups)} pairs of groups", file=sys.stderr)


if __name__ == "__main__":
    main()
