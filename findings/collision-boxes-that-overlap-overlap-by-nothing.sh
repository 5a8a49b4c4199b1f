#!/usr/bin/env bash
# Finding: In collision two boxes that overlap at their sides have an overlap of zero, wherever they lie; circles have the right one, and so has a circle on a box.
# Package: collision 1.2.2 (PyPI)
# Expected: Boxes 2 wide whose centres are 1.7 apart overlap by 0.3 along the line of centres, and the overlap vector taken from the first sets them apart, as the package says.
# Seen: Contact is found and the normal points along the line of centres, but the overlap is 0 from all four sides, and the boxes stay where they are; at an offset of both axes even the normal is that of the deeper overlap.
# Touches carom: A depth of contact from this package is no input for a contact law of carom unless one of the bodies is a circle.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check setuptools==75.8.0 wheel==0.45.1
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-build-isolation --no-deps collision==1.2.2
cd "$folder"
cat > boxes.py <<'PYTHON'
import importlib.metadata
import sys

from collision import Circle, Poly, Response, Vector, collide

print("collision", importlib.metadata.version("collision"))


def box(x: float, y: float) -> Poly:
    return Poly(Vector(x, y), [Vector(-1, -1), Vector(1, -1), Vector(1, 1), Vector(-1, 1)])


def ball(x: float, y: float) -> Circle:
    return Circle(Vector(x, y), 1)


fault = False
for kind, first, second in (("boxes", box, box), ("circles", ball, ball), ("box and circle", box, ball), ("circle and box", ball, box)):
    for x, y in ((1.7, 0), (-1.7, 0), (0, 1.7), (0, -1.7)):
        a, b = first(0, 0), second(x, y)
        response = Response()
        hit = collide(a, b, response)
        normal = response.overlap_n
        again = collide(first(-response.overlap_v.x, -response.overlap_v.y), b, Response())
        print(f"{kind}, the second at ({x:g}, {y:g}): expected an overlap of 0.3, seen {response.overlap:.4f}, "
              f"normal ({normal.x:g}, {normal.y:g})" + (", still in contact when set apart" if again and response.overlap == 0 else ""))
        fault |= not hit or abs(normal.x - x / 1.7) > 1e-9 or abs(normal.y - y / 1.7) > 1e-9
        fault |= abs(response.overlap - (0 if kind == "boxes" else 0.3)) > 1e-9 or (kind == "boxes") and not again
# The shortest axis: 0.3 along x against 1.7 along y.
response = Response()
collide(box(0, 0), box(1.7, -0.3), response)
print(f"boxes, the second at (1.7, -0.3): expected normal (1, 0), seen ({response.overlap_n.x:g}, {response.overlap_n.y:g}), overlap {response.overlap:g}")
fault |= abs(response.overlap_n.y + 1) > 1e-9 or response.overlap != 0
sys.exit(int(fault))
PYTHON
env/bin/python boxes.py
