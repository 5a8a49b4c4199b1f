"""Seconds of contact programs beside carom's, each in a process of its own, one thread, in one run.

    cargo build --release -p carom-benches --example one_contact
    python solvers.py ../../target/release/examples/one_contact 128 256 512

ContactMechanics 1.8.3 solves Hertz's problem (pip install ContactMechanics), slippy 0.5.2 that and
Cattaneo's; slippy wants packages of 2023, so that it gets an environment of its own: SLIPPY names
its python (numpy==1.23.5 scipy==1.10.1 numba==0.57.1 pyfftw==0.13.1, slippy --no-deps). A program that
is not there is left out. Times are of set-up and solution, without imports; the least of three runs.
The error is that of the free quantity against the closed form, by the mesh.
"""

import json
import os
import subprocess
import sys
import tempfile
import time

RADIUS, SHEAR, SIDE, FRICTION = 100.0, 80000.0, 2.4, 0.4
ONE = {
    name: "1"
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")
}


def closed_form(poisson):
    """Modulus, force, approach at a = 1."""
    modulus = SHEAR / (1 - poisson)
    return modulus, 4 / 3 * modulus / RADIUS, 1 / RADIUS


def paraboloid(cells):
    import numpy as np

    width = SIDE / cells
    x = (np.arange(cells) + 0.5) * width - SIDE / 2
    return width, (x[:, None] ** 2 + x[None, :] ** 2) / (2 * RADIUS)


def contact_mechanics(case, cells):
    from ContactMechanics import FreeFFTElasticHalfSpace
    from ContactMechanics.Systems import NonSmoothContactSystem
    from SurfaceTopography import Topography

    modulus, force, approach = closed_form(0.3)
    width, height = paraboloid(cells)
    begin = time.perf_counter()
    substrate = FreeFFTElasticHalfSpace((cells, cells), modulus, (SIDE, SIDE))
    system = NonSmoothContactSystem(substrate, Topography(-height, (SIDE, SIDE)))
    by_force = case == "hertz_force"
    given = {"external_force": force} if by_force else {"offset": approach}
    found = system.minimize_proxy(pentol=1e-7, maxiter=2000, **given)
    seconds = time.perf_counter() - begin
    got = found.offset / approach if by_force else abs(found.jac.sum()) / force
    return {"seconds": seconds, "error": float(got - 1)}


def slippy(case, cells):
    # It writes where it stands.
    os.chdir(tempfile.mkdtemp())
    import matplotlib

    matplotlib.use("Agg")
    import numpy as np
    import slippy

    slippy.CUDA = False
    import slippy.contact as contact
    import slippy.surface as surface
    from slippy.contact.sub_models._TransientSubModelABC import _TransientSubModelABC as base

    poisson = 0.0 if case == "cattaneo" else 0.3
    modulus, force, approach = closed_form(poisson)
    width, height = paraboloid(cells)
    profile = -height - (-height).min()
    begin = time.perf_counter()
    bodies = [surface.Surface(profile=profile, grid_spacing=width), surface.FlatSurface(shift=(0, 0))]
    for name, body in zip("ab", bodies):
        constants = {"E": 2 * SHEAR * (1 + poisson), "v": poisson}
        body.material = contact.Elastic(name, constants, use_frequency_domain=False)
    model = contact.ContactModel("model", *bodies)
    given = {"interference": approach} if case == "hertz_approach" else {"normal_load": force}
    step = contact.StaticStep("step", **given)
    if case == "cattaneo":
        def repaired(self, state):
            # 0.5.2 throws the results of such models away.
            self.update_transience(state["time"])
            result = dict(self.updated_dict)
            result.update(self._solve(state, **self.updated_dict))
            return result

        base.solve = repaired
        shift = 0.75 * 3 * FRICTION * force * (2 - poisson) / (8 * SHEAR)
        step.add_sub_model(contact.sub_models.FrictionCoulombSimple("friction", FRICTION))
        step.add_sub_model(contact.sub_models.TangentialPartialSlip(1, shift))
    model.add_step(step)
    out = model.solve(skip_data_check=True)
    seconds = time.perf_counter() - begin
    area = width * width
    if case == "cattaneo":
        got = abs(np.asarray(out["loads_x"]).sum()) * area / (0.875 * FRICTION * force)
    elif case == "hertz_force":
        got = out["interference"] / approach
    else:
        got = np.asarray(out["loads_z"]).sum() * area / force
    return {"seconds": seconds, "error": float(got - 1)}


PEERS = {"contact_mechanics": contact_mechanics, "slippy": slippy}


def ours(program, case, cells, tolerance):
    run = subprocess.run([program, case, str(cells), tolerance], capture_output=True, text=True)
    told = json.loads(run.stdout)
    return {"seconds": told["set_up"] + told["solve"], "error": told["error"]}


def theirs(peer, case, cells):
    python = os.environ.get("SLIPPY") if peer == "slippy" else sys.executable
    if not python:
        return None
    command = [python, os.path.abspath(__file__), "--peer", peer, case, str(cells)]
    try:
        run = subprocess.run(
            command, capture_output=True, text=True, timeout=300, env={**os.environ, **ONE}
        )
        return json.loads(run.stdout.strip().splitlines()[-1])
    except (subprocess.TimeoutExpired, ValueError, IndexError):
        return None


def best(runs):
    runs = [run for run in runs if run]
    return min(runs, key=lambda run: run["seconds"]) if runs else None


def main(program, sizes):
    print(f"{'case':16}{'cells':>6}  {'carom':>9}{'error':>10}  others: seconds, error, times carom's")
    for case, peers in [
        ("hertz_force", ["contact_mechanics", "slippy"]),
        ("hertz_approach", ["contact_mechanics", "slippy"]),
        ("cattaneo", ["slippy"]),
    ]:
        for cells in sizes:
            own = best(ours(program, case, cells, "1e-6") for _ in range(5))
            line = f"{case:16}{cells:6}  {own['seconds']:9.4f}{own['error']:10.1e}"
            for peer in peers:
                runs = 3 if cells < 512 else 1
                other = best(theirs(peer, case, cells) for _ in range(runs))
                if other:
                    times = other["seconds"] / own["seconds"]
                    line += f"  {peer} {other['seconds']:.3f} {other['error']:.1e} {times:.1f}"
            print(line, flush=True)


if __name__ == "__main__":
    if sys.argv[1] == "--peer":
        print(json.dumps(PEERS[sys.argv[2]](sys.argv[3], int(sys.argv[4]))))
    else:
        main(sys.argv[1], [int(size) for size in sys.argv[2:]])
