"""One case by one peer: `solvers.py PEER CASE CELLS` prints a line of JSON: seconds of set-up and solution
without imports, by the clock and by the processor, and the error of the free quantity against the closed form.

ASPHER, ContactMechanics and tamaas solve Hertz's problem, slippy that and Cattaneo's along one axis. A case that a
peer does not have ends with code 2. `rounds.py` runs this with the environment of each peer.
"""

import json
import os
import sys
import tempfile
import time

from problem import FRICTION, SHEAR, SIDE, Problem, paraboloid


class Clock:
    """Seconds of set-up and of solution by the clock, and of both together by the processor."""

    def __init__(self):
        self.times = [time.perf_counter()]
        self.processor = time.process_time()

    def lap(self):
        self.times.append(time.perf_counter())
        self.used = time.process_time() - self.processor

    def told(self, error):
        begin, ready, end = self.times
        return {"set_up": ready - begin, "solve": end - ready, "processor": self.used, "error": error}


def contact_mechanics(case, cells):
    from ContactMechanics import FreeFFTElasticHalfSpace
    from ContactMechanics.Systems import NonSmoothContactSystem
    from SurfaceTopography import Topography

    problem = Problem(case)
    _, gap = paraboloid(cells)
    clock = Clock()
    substrate = FreeFFTElasticHalfSpace((cells, cells), problem.modulus, (SIDE, SIDE))
    system = NonSmoothContactSystem(substrate, Topography(-gap, (SIDE, SIDE)))
    clock.lap()
    given = {"external_force": problem.force} if problem.by_force else {"offset": problem.approach}
    found = system.minimize_proxy(pentol=1e-7, maxiter=2000, **given)
    clock.lap()
    return clock.told(problem.error(abs(found.jac.sum()), found.offset))


def tamaas(case, cells):
    import tamaas as tm

    tm.set_log_level(tm.LogLevel.error)
    problem = Problem(case)
    width, gap = paraboloid(cells)
    clock = Clock()
    model = tm.Model(tm.model_type.basic_2d, [SIDE, SIDE], [cells, cells])
    model.nu = problem.poisson
    model.E = problem.modulus * (1 - problem.poisson**2)
    tm.ModelFactory.registerNonPeriodic(model, "dcfft")
    solver = tm.PolonskyKeerRey(model, -gap, 1e-8)
    solver.setIntegralOperator("dcfft")
    clock.lap()
    solver.solve(problem.force / SIDE**2)
    clock.lap()
    pressure = model.traction
    model.operators["dcfft"](pressure, model.displacement)
    approach = (model.displacement + gap)[pressure > 0].mean()
    return clock.told(problem.error(pressure.sum() * width**2, approach))


def repair_slippy():
    """Release 0.5.2 throws the results of models that change in time away."""
    from slippy.contact.sub_models._TransientSubModelABC import _TransientSubModelABC as base

    def repaired(self, state):
        self.update_transience(state["time"])
        result = dict(self.updated_dict)
        result.update(self._solve(state, **self.updated_dict))
        return result

    base.solve = repaired


def slippy(case, cells):
    # It writes where it stands.
    os.chdir(tempfile.mkdtemp())
    import matplotlib

    matplotlib.use("Agg")
    import slippy

    slippy.CUDA = False
    slippy.CORES = 1
    import slippy.contact as contact
    import slippy.surface as surface

    repair_slippy()
    problem = Problem(case)
    width, gap = paraboloid(cells)
    clock = Clock()
    bodies = [
        surface.Surface(profile=gap.max() - gap, grid_spacing=width),
        surface.FlatSurface(shift=(0, 0)),
    ]
    for name, body in zip("ab", bodies):
        constants = {"E": 2 * SHEAR * (1 + problem.poisson), "v": problem.poisson}
        # Its default is meant for periodic surfaces.
        body.material = contact.Elastic(name, constants, use_frequency_domain=False)
    model = contact.ContactModel("model", *bodies)
    given = {"normal_load": problem.force} if problem.by_force else {"interference": problem.approach}
    step = contact.StaticStep("step", **given)
    if problem.is_shifted:
        step.add_sub_model(contact.sub_models.FrictionCoulombSimple("friction", FRICTION))
        step.add_sub_model(contact.sub_models.TangentialPartialSlip(1, problem.shift))
    model.add_step(step)
    clock.lap()
    out = model.solve(skip_data_check=True)
    clock.lap()
    normal = out["loads_z"].sum() * width**2
    tangential = out["loads_x"].sum() * width**2 if problem.is_shifted else None
    return clock.told(problem.error(normal, out["interference"], tangential))


def aspher(case, cells):
    import aspher as solver

    problem = Problem(case)
    width, gap = paraboloid(cells)
    clock = Clock()
    clock.lap()
    # Transforms in double precision are its fastest way to an answer of this accuracy.
    found = solver.solve_nested(
        grid_size=cells, gap=gap.ravel(), p_nominal=problem.force / SIDE**2, domain_size=SIDE,
        E_star=problem.modulus, coarsest=64, backend="fft", tol=1e-8,
    )
    clock.lap()
    return clock.told(problem.error(found.pressure.sum() * width**2, found.approach))


PEERS = {
    "ASPHER": (aspher, ("hertz_force",)),
    "ContactMechanics": (contact_mechanics, ("hertz_force", "hertz_approach")),
    "tamaas": (tamaas, ("hertz_force",)),
    "slippy": (slippy, ("hertz_force", "hertz_approach", "cattaneo")),
}


if __name__ == "__main__":
    peer, case, cells = sys.argv[1:]
    solve, cases = PEERS[peer]
    if case not in cases:
        sys.exit(2)
    print(json.dumps(solve(case, int(cells))))
