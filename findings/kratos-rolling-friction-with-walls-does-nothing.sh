#!/usr/bin/env bash
# Finding: In KratosDEM the rolling friction with walls of a relation of particle and wall does nothing; the ball obeys the one beside it.
# Package: KratosDEMApplication 10.4.4 (PyPI), KratosMultiphysics 10.4.4 (PyPI)
# Expected: A ball that rolls on a wall is slowed by ROLLING_FRICTION_WITH_WALLS of their relation, as the name says, and not by ROLLING_FRICTION beside it.
# Seen: With 0.1 for walls and 0 for particles the ball of 1 m/s rolls on without loss; exchanged it slows to 0.93 m/s, in all three models of rolling friction.
# Touches carom: carom's `rolling` of a wall in LAMMPS acts at that wall. For a comparison set both coefficients of Kratos's relation of particle and wall to one value.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check KratosDEMApplication==10.4.4 KratosMultiphysics==10.4.4 numpy==2.4.6
cd "$folder"
cat > roll.py <<'PYTHON'
import importlib.metadata
import json
import sys

import KratosMultiphysics as kratos
from KratosMultiphysics.DEMApplication.DEM_analysis_stage import DEMAnalysisStage

kratos.Logger.GetDefaultOutput().SetSeverity(kratos.Logger.Severity.WARNING)
RADIUS = 0.1
HEAD = "Begin ModelPartData\nEnd ModelPartData\n\nBegin Properties {}\nEnd Properties\n\n"


def part(name: str, ids: str, kind: str, data: str = "") -> str:
    return (f"Begin SubModelPart {name}\n{data}Begin SubModelPartNodes\n{ids}End SubModelPartNodes\n"
            f"Begin SubModelPart{kind}\n1\nEnd SubModelPart{kind}\nEnd SubModelPart\n")


ball = HEAD.format(1) + f"Begin Nodes\n1 0 0 {RADIUS - 1e-5}\nEnd Nodes\n\nBegin Elements SphericParticle3D\n1 1 1\nEnd Elements\n\n"
for name, value in (("RADIUS", RADIUS), ("VELOCITY_X", 1.0), ("ANGULAR_VELOCITY_Y", 1.0 / RADIUS)):
    ball += f"Begin NodalData {name}\n1 0 {value}\nEnd NodalData\n\n"
ball += part("Parts_Body", "1\n", "Elements")
wall = HEAD.format(2) + "Begin Nodes\n11 -5 -5 0\n12 5 -5 0\n13 0 9 0\nEnd Nodes\n\nBegin Conditions RigidFace3D3N\n1 2 11 12 13\nEnd Conditions\n\n"
wall += part("1", "11\n12\n13\n", "Conditions", "Begin SubModelPartData\nRIGID_BODY_MOTION 0\nFREE_BODY_MOTION 0\nFIXED_MESH_OPTION 0\nIS_GHOST 0\n"
             "IDENTIFIER floor\nTOP 0\nBOTTOM 0\nFORCE_INTEGRATION_GROUP 0\nEnd SubModelPartData\n")
for name, text in (("DEM", ball), ("DEM_FEM_boundary", wall), ("DEM_Inlet", ""), ("DEM_Clusters", "")):
    with open(f"roll{name}.mdpa", "w") as file:
        file.write(text or "Begin ModelPartData\nEnd ModelPartData\n")


class Stage(DEMAnalysisStage):
    def FinalizeSolutionStep(self):
        super().FinalizeSolutionStep()
        self.speed = next(iter(self.spheres_model_part.Nodes)).GetSolutionStepValue(kratos.VELOCITY_X)


def roll(model: str, particles: float, walls: float) -> float:
    """Speed after 0.1 s of a ball that begins to roll on the wall with 1 m/s."""
    elastic = {"YOUNG_MODULUS": 1e7, "POISSON_RATIO": 0.25}
    law = {
        "COEFFICIENT_OF_RESTITUTION": 0.2, "STATIC_FRICTION": 0.5, "DYNAMIC_FRICTION": 0.5, "FRICTION_DECAY": 500,
        "ROLLING_FRICTION": particles, "ROLLING_FRICTION_WITH_WALLS": walls, "DEM_ROLLING_FRICTION_MODEL_NAME": model,
        "DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME": "DEM_D_Linear_viscous_Coulomb",
        "SEVERITY_OF_WEAR": 0.001, "IMPACT_WEAR_SEVERITY": 0.001, "BRINELL_HARDNESS": 200.0,
    }
    materials = [("ball", 1, {"PARTICLE_DENSITY": 2000.0, **elastic}), ("wall", 2, {**elastic, "COMPUTE_WEAR": False})]
    with open("materials.json", "w") as file:
        json.dump({
            "materials": [{"material_name": name, "material_id": number, "Variables": values} for name, number, values in materials],
            "material_relations": [{"material_names_list": ["ball", name], "material_ids_list": [1, number], "Variables": law}
                                   for name, number, _ in materials],
            "material_assignation_table": [["SpheresPart", "ball"], ["RigidFacePart", "wall"]],
        }, file)
    stage = Stage(kratos.Model(), kratos.Parameters(json.dumps({
        "Dimension": 3, "GravityX": 0.0, "GravityY": 0.0, "GravityZ": -10.0, "RotationOption": True, "RollingFrictionOption": True,
        "solver_settings": {"RemoveBallsInitiallyTouchingWalls": False, "strategy": "sphere_strategy",
                            "material_import_settings": {"materials_filename": "materials.json"}},
        "MaxTimeStep": 2e-5, "FinalTime": 0.1, "OutputTimeStep": 1e3, "GraphExportFreq": 1e3, "problem_name": "roll", "post_gid_option": False,
    })))
    stage.Run()
    return stage.speed


lines = []
fault = False
for model in ("Bounded", "ConstantTorque", "ViscousTorque"):
    free, first, second, both = (roll(f"DEMRollingFrictionModel{model}", *pair) for pair in ((0, 0), (0.1, 0), (0, 0.1), (0.1, 0.1)))
    lines.append(f"{model}: speed without {free:.4f} m/s; ROLLING_FRICTION 0.1 alone: expected {free:.4f}, seen {first:.4f}; "
                 f"ROLLING_FRICTION_WITH_WALLS 0.1 alone: expected {both:.4f}, seen {second:.4f}")
    fault |= abs(second - free) > 1e-6 or abs(first - both) > 1e-6 or not 0.9 < both < 0.95
print(f"\nKratosDEMApplication {importlib.metadata.version('KratosDEMApplication')}", *lines, sep="\n")
sys.exit(int(fault))
PYTHON
OMP_NUM_THREADS=1 env/bin/python roll.py | grep -A 4 "^KratosDEMApplication"
