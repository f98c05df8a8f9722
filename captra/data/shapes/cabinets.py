"""The base of cabinets: an open carcass of boards on a plinth, feet or legs, with a top."""

import numpy as np

from captra.data.shapes.cabinet_plan import CabinetPlan
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.plates import Rectangle, plate
from captra.data.shapes.surfaces import box, revolve


def board(low: tuple[float, float, float], high: tuple[float, float, float]) -> Mesh:
    """Box between two corners."""
    return box(np.subtract(high, low)).moved(translation=(np.add(low, high)) / 2)


def make_carcass(rng: np.random.Generator, plan: CabinetPlan) -> list[Mesh]:
    """Everything that does not slide, but for fixed fronts."""
    x, z, p = plan.width / 2, plan.depth / 2, plan.panel
    low, high = plan.foot, plan.height - plan.top
    meshes = [
        board((-x, low, -z), (-x + p, high, z)),
        board((x - p, low, -z), (x, high, z)),
        board((-x + p, low, -z), (x - p, high, -z + min(p, 0.012))),
        board((-x + p, low, -z), (x - p, low + p, z)),
    ]
    meshes += [_divider(plan, k) for k in range(1, plan.columns)]
    return [*meshes, *_rails(rng, plan), *_shelf(plan), *_top(rng, plan), *_stand(rng, plan)]


def _divider(plan: CabinetPlan, index: int) -> Mesh:
    cells = plan.rows[0]
    left, right = cells[index - 1][2], cells[index][0]
    return board((left, plan.foot, -plan.depth / 2), (right, plan.height - plan.top, plan.depth / 2))


def _rails(rng: np.random.Generator, plan: CabinetPlan) -> list[Mesh]:
    """Boards between the rows: strips at the front, or whole floors."""
    x, z = plan.width / 2 - plan.panel, plan.depth / 2
    levels = sorted({cell[3] for row in plan.rows for cell in row} | {cell[3] for cell in plan.fixed})
    if plan.open_shelf is not None:
        levels.append(plan.open_shelf[3])
    back = -z if chance(rng, 0.4) else z - 0.04
    if plan.rail == 0:
        return []
    inside = [level for level in levels if level + plan.rail < plan.height - plan.top + 1e-6]
    return [board((-x, level, back), (x, level + plan.rail, z)) for level in inside]


def _shelf(plan: CabinetPlan) -> list[Mesh]:
    """Floor or ceiling of an opening without a drawer."""
    if plan.open_shelf is None:
        return []
    left, low, right, high = plan.open_shelf
    z, thick = plan.depth / 2, min(plan.panel, 0.02)
    above = high > plan.rows[-1][0][3]
    level = low if above else high - thick
    return [board((left, level, -z), (right, level + thick, z))]


def _top(rng: np.random.Generator, plan: CabinetPlan) -> list[Mesh]:
    """Flush, overhanging or rounded; a rim or a backsplash now and then."""
    x, z = plan.width / 2, plan.depth / 2
    side = pick(rng, ((3, 0.0), (3, between(rng, 0.0, 0.03))))
    front = side if chance(rng, 0.5) else between(rng, 0.0, 0.045)
    # `Rectangle` names its second coordinate z, which is the depth here.
    outline = Rectangle((-x - side, -z), (x + side, z + front), between(rng, 0.0, 0.03) if chance(rng, 0.2) else 0.0)
    bevel = between(rng, 0.0, 0.4) * plan.top
    meshes = [plate(outline, plan.height - plan.top, plan.height, bevel)]
    if chance(rng, 0.15):
        tall, thick = between(rng, 0.02, 0.12), between(rng, 0.008, 0.03)
        meshes.append(board((-x - side, plan.height, -z), (x + side, plan.height + tall, -z + thick)))
        if chance(rng, 0.3):
            for sign in (-1, 1):
                ends = sorted((sign * (x + side), sign * (x + side - thick)))
                meshes.append(board((ends[0], plan.height, -z), (ends[1], plan.height + tall, z)))
    return meshes


def _stand(rng: np.random.Generator, plan: CabinetPlan) -> list[Mesh]:
    """A recessed plinth, sides down to the floor, feet, legs or castors."""
    x, z, foot = plan.width / 2, plan.depth / 2, plan.foot
    if foot < 0.004:
        return []
    kind = pick(rng, ((3, "plinth"), (2, "sides"), (1.5, "feet"), (2, "legs")))
    back = between(rng, 0.0, 0.08) if kind != "feet" else 0.0
    if kind == "plinth":
        inset = between(rng, 0.0, 0.03) if chance(rng, 0.5) else 0.0
        return [board((-x + inset, 0, -z + inset), (x - inset, foot + 1e-4, z - back))]
    if kind == "sides":
        sides = [board((left, 0, -z), (left + plan.panel, foot + 1e-4, z)) for left in (-x, x - plan.panel)]
        return [*sides, board((-x, 0, z - back - plan.panel), (x, foot + 1e-4, z - back))]
    thick = between(rng, 0.012, 0.045) * min(1.0, plan.width / 0.4)
    inset = thick / 2 + (between(rng, 0.0, 0.04) if kind == "legs" else 0.0)
    taper = between(rng, 0.5, 1.1)
    round_outline = np.array([[0, 0], [taper * thick / 2, 0], [thick / 2, foot + 1e-4], [0, foot + 1e-4]])
    leg = (
        revolve(round_outline, segments=12)
        if chance(rng, 0.5)
        else board((-thick / 2, 0, -thick / 2), (thick / 2, foot + 1e-4, thick / 2))
    )
    corners = [(sx * (x - inset), sz * (z - inset)) for sx in (-1, 1) for sz in (-1, 1)]
    return [leg.moved(translation=np.array([cx, 0, cz])) for cx, cz in corners]
