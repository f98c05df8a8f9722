"""What slides: a front with its handle, and an open box behind it that is seen into from above."""

from dataclasses import dataclass

import numpy as np

from captra.data.shapes.cabinet_plan import CabinetPlan, Cell
from captra.data.shapes.cabinets import board
from captra.data.shapes.drawer_handles import HandleMaker, draw_handle
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.plates import Rectangle, plate, plate_with_well
from captra.geometry import axis_angle

TO_FRONT = axis_angle(np.array([1.0, 0, 0]), np.pi / 2)
"""Carries y (out of a plate) to z; a plate's z becomes -y."""


@dataclass(frozen=True)
class DrawerBuilder:
    """How all drawers of one cabinet are made, metres."""

    face: float
    """z of the outer side of the fronts."""
    thickness: float
    """Of the fronts."""
    margin: tuple[float, float]
    """By which fronts reach beyond their opening (negative: leave a slit), x and y."""
    bevel: float
    """Of their edges."""
    panel: tuple[float, float]
    """Width of the frame around a sunk panel, and by how much it is sunk (raised if negative); 0 for plain fronts."""
    box_depth: float
    """Of the box behind the front."""
    wall: float
    """Thickness of its boards."""
    clearance: float
    """Between its sides and the carcass."""
    side_height: float
    """Height of its sides over that of the front."""
    handle: HandleMaker
    """Makes the handles of a front."""

    @staticmethod
    def draw(rng: np.random.Generator, plan: CabinetPlan) -> "DrawerBuilder":
        """Inset, flush, recessed or overlapping fronts; shallow or deep boxes."""
        unit = min(1.0, plan.width / 0.4)
        thickness = between(rng, 0.01, 0.024) * unit
        slit = between(rng, 0.001, 0.004)
        style = pick(rng, ((3, "inset"), (1.5, "recessed"), (4.5, "overlapping")))
        face = plan.depth / 2
        margin = (-slit, -slit)
        if style == "recessed":
            face -= between(rng, 0.003, 0.03) * unit
        elif style == "overlapping":
            face += thickness if chance(rng, 0.75) else thickness * between(rng, 0.2, 1.0)
            covered = plan.panel / (2 if plan.columns > 1 else 1)
            margin = (covered * between(rng, 0.3, 1.0) - slit, plan.rail / 2 * between(rng, 0.3, 1.0) - slit)
        elif chance(rng, 0.3):
            face += between(rng, 0.0, 0.5) * thickness
        framed = chance(rng, 0.35)
        behind = face - thickness
        full = behind + plan.depth / 2 - min(plan.panel, 0.012)
        return DrawerBuilder(
            face=face,
            thickness=thickness,
            margin=margin,
            bevel=pick(rng, ((2, 0.0), (2, between(rng, 0.001, 0.006)))),
            panel=(between(rng, 0.02, 0.06) * unit, between(rng, -0.006, 0.009)) if framed else (0.0, 0.0),
            box_depth=full * (between(rng, 0.8, 0.99) if chance(rng, 0.8) else between(rng, 0.5, 0.8)),
            wall=between(rng, 0.004, 0.016) * unit,
            clearance=between(rng, 0.001, 0.014) * unit,
            side_height=between(rng, 0.4, 0.95),
            handle=draw_handle(rng, plan),
        )

    def drawer(self, cell: Cell) -> list[Mesh]:
        """Front, handle and box of an opening."""
        left, low, right, high = cell
        x0, x1 = left + self.clearance, right - self.clearance
        y0 = low + 0.006
        y1 = y0 + (high - low - 0.012) * self.side_height
        z1 = self.face - self.thickness + 1e-4
        z0, w = z1 - self.box_depth, self.wall
        raised = y0 + min(0.012, 0.1 * (high - low))
        walls = [
            board((x0, y0, z0), (x0 + w, y1, z1)),
            board((x1 - w, y0, z0), (x1, y1, z1)),
            board((x0 + w, y0, z0), (x1 - w, y1, z0 + w)),
            board((x0 + w, raised, z0 + w), (x1 - w, raised + 0.5 * w, z1)),
        ]
        return [*self.fixed_front(cell), *walls]

    def fixed_front(self, cell: Cell) -> list[Mesh]:
        """Front and handle alone."""
        left, low, right, high = cell
        size = right - left + 2 * self.margin[0], high - low + 2 * self.margin[1]
        front = Rectangle.centred(*size)
        at = np.array([(left + right) / 2, (low + high) / 2, self.face])
        return [mesh.moved(TO_FRONT, at) for mesh in self._face(front)] + self.handle(cell, self.face)

    def _face(self, front: Rectangle) -> list[Mesh]:
        """Lying: its outer side up at y = 0."""
        frame = min(self.panel[0], 0.3 * (front.high[1] - front.low[1]))
        inner = front.shrunk(frame)
        if frame < 0.006 or abs(self.panel[1]) < 0.001:
            return [plate(front, -self.thickness, 0.0, self.bevel)]
        if self.panel[1] > 0:
            return [
                plate_with_well(
                    front, -self.thickness, 0.0, inner, min(self.panel[1], 0.6 * self.thickness), self.bevel
                )
            ]
        return [
            plate(front, -self.thickness, 0.0, self.bevel),
            plate(inner, -0.5 * self.thickness, -self.panel[1], 0.7 * -self.panel[1]),
        ]
