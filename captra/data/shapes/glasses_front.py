"""The base of glasses: lenses, rims, bridge, nose pads and end pieces up to the hinges."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from jaxtyping import Float64

from captra.data.shapes.curves import rounded_polyline, superellipse
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.glasses_lenses import Outline, draw_style, lens, lens_outline, shield_outline
from captra.data.shapes.loops import bent, bent_mesh, closed_sweep, mirrored
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.surfaces import revolve, superellipsoid, sweep, tube

Y, Z = np.eye(3)[1:]
Rim = Literal["wire", "broad", "upper", "lower", "none"]


@dataclass(frozen=True)
class FrontPlan:
    """Measures of a front before it is wrapped around the face, metres."""

    outline: Outline
    """The lens at +x in place, or the one lens of a shield."""
    shield: bool
    """One lens for both eyes."""
    gap: float
    """Between the lenses."""
    rim: Rim
    """What is around the lenses."""
    rim_width: float
    """In the plane of the lens."""
    rim_depth: float
    """Across it."""
    hinge_height: float
    """y of the hinges."""
    joint_height: float
    """Extent of end piece and temple along y at the hinge."""
    joint_width: float
    """Their extent across."""
    wrap_radius: float
    """Of the cylinder that the front is bent around."""

    @property
    def outer(self) -> float:
        """Largest x of the lens."""
        return float(self.outline[:, 0].max())


def draw_front(rng: np.random.Generator) -> FrontPlan:
    """Draw the measures that front and temples share."""
    if chance(rng, 0.14):
        return _shield_plan(rng)
    style = draw_style(rng)
    rim: Rim = pick(rng, ((3.0, "wire"), (5.0, "broad"), (1.2, "upper"), (0.3, "lower"), (1.4, "none")))
    broad = rim == "broad" or (rim == "upper" and chance(rng, 0.6))
    width = between(rng, 0.0022, 0.007) if broad else between(rng, 0.0009, 0.0022)
    depth = between(rng, 0.0025, 0.006) if broad else between(rng, 0.001, 0.003)
    gap = between(rng, 0.014, 0.024)
    outline = lens_outline(style)
    outline = outline + [gap / 2 - outline[:, 0].min(), 0.0]
    tall = (
        pick(rng, ((4, between(rng, 0.003, 0.008)), (1.5, between(rng, 0.008, 0.02))))
        if broad
        else between(rng, 0.0012, 0.006)
    )
    height = float(outline[:, 1].max()) * pick(rng, ((3, between(rng, 0.45, 0.95)), (1, between(rng, -0.1, 0.5))))
    return FrontPlan(
        outline=outline,
        shield=False,
        gap=gap,
        rim=rim,
        rim_width=width,
        rim_depth=depth,
        hinge_height=height,
        joint_height=tall,
        joint_width=between(rng, 0.002, 0.0045) if broad else between(rng, 0.001, 0.0025),
        wrap_radius=pick(rng, ((4, between(rng, 0.25, 1.0)), (1.5, between(rng, 0.1, 0.25)))),
    )


def _shield_plan(rng: np.random.Generator) -> FrontPlan:
    outline = shield_outline(rng)
    tall = float(outline[:, 1].max())
    return FrontPlan(
        outline=outline,
        shield=True,
        gap=0.0,
        rim=pick(rng, ((2, "broad"), (1, "upper"), (1, "none"))),
        rim_width=between(rng, 0.0015, 0.005),
        rim_depth=between(rng, 0.002, 0.004),
        hinge_height=tall * between(rng, 0.0, 0.7),
        joint_height=between(rng, 0.004, 0.9 * tall),
        joint_width=between(rng, 0.0015, 0.004),
        wrap_radius=pick(rng, ((3, between(rng, 0.072, 0.11)), (1, between(rng, 0.11, 0.25)))),
    )


def make_front(rng: np.random.Generator, plan: FrontPlan) -> tuple[list[Mesh], Float64[np.ndarray, " 3"]]:
    """The meshes of the base, and where the hinge at +x is."""
    side = [*_lens(rng, plan), *_rim(plan), *_pads(rng, plan)]
    corner, back = between(rng, 0.001, 0.009), -between(rng, 0.002, 0.013)
    hinge = np.array([plan.outer + corner, plan.hinge_height, back])
    side += [_end_piece(plan, hinge), _barrel(rng, plan, hinge)]
    if plan.shield:
        whole, side = side[:-2], side[-2:]
        meshes = [*whole, *side, *(mirrored(mesh, axis=0) for mesh in side)]
    else:
        meshes = [*side, *(mirrored(mesh, axis=0) for mesh in side), *_bridge(rng, plan)]
    return [bent_mesh(mesh, plan.wrap_radius) for mesh in meshes], bent(hinge[None], plan.wrap_radius)[0]


def _lens(rng: np.random.Generator, plan: FrontPlan) -> list[Mesh]:
    """Clear lenses that a depth camera looks through are left out where a rim stands for them."""
    if plan.rim in {"wire", "broad"} and not plan.shield and chance(rng, 0.12):
        return []
    middle = (plan.outline.max(0) + plan.outline.min(0)) / 2
    if plan.shield:
        middle[1] = 0.45 * plan.outline[:, 1].max()
    bulge = 0.0 if plan.shield else between(rng, 0.0, 0.0045)
    return [lens(plan.outline, (float(middle[0]), float(middle[1])), between(rng, 0.0012, 0.003), bulge)]


def _rim(plan: FrontPlan) -> list[Mesh]:
    if plan.rim == "none":
        return []
    curve = np.insert(plan.outline, 2, 0.0, axis=1)
    section = superellipse(8, 3.0, (plan.rim_width / 2, plan.rim_depth / 2))
    if plan.rim in {"wire", "broad"}:
        return [closed_sweep(curve, section, Z)]
    count = len(curve)
    half = np.arange(-count // 16, count // 2 + count // 16 + 1)
    start = 0 if plan.rim == "upper" else count // 2
    return [sweep(curve[(half + start) % count], section, Z)]


def _bridge(rng: np.random.Generator, plan: FrontPlan) -> list[Mesh]:
    """One bar, an arch or a saddle between the lenses; a second bar above it now and then."""
    top = float(plan.outline[:, 1].max())
    level = top * between(rng, 0.1, 0.75)
    meshes = [_bar(rng, plan, level, between(rng, 0.0, 0.007))]
    if chance(rng, 0.18):
        meshes.append(_bar(rng, plan, top * between(rng, 0.85, 1.0), 0.0))
    return meshes


def _bar(rng: np.random.Generator, plan: FrontPlan, level: float, arch: float) -> Mesh:
    near = plan.outline[(np.abs(plan.outline[:, 1] - level) < 0.004) & (plan.outline[:, 0] < plan.outline[:, 0].mean())]
    reach = float(near[:, 0].min() if len(near) else plan.gap / 2 + 0.006) + 0.0008
    x = np.linspace(-reach, reach, 13)
    y = level + arch * (1 - (x / reach) ** 2)
    curve = np.column_stack([x, y, np.zeros(13)])
    tall = between(rng, 0.003, 0.009) if plan.rim == "broad" else max(plan.rim_width, 0.0012)
    return sweep(curve, superellipse(8, 3.0, (tall / 2, max(plan.rim_depth, 0.0012) / 2)), Z)


def _pads(rng: np.random.Generator, plan: FrontPlan) -> list[Mesh]:
    if not chance(rng, 0.35 if plan.rim == "broad" else 0.85):
        return []
    size = (between(rng, 0.002, 0.004), between(rng, 0.009, 0.014), between(rng, 0.005, 0.008))
    inner = plan.gap / 2 if not plan.shield else 0.009
    at = np.array([inner - between(rng, -0.001, 0.002), between(rng, -0.008, 0.002), -between(rng, 0.004, 0.01)])
    pad = superellipsoid(size, 2.2, 12).moved(translation=at)
    rim = np.array([inner + 0.002, at[1] + between(rng, 0.001, 0.006), 0.0])
    middle = (rim + at) / 2 + [0.0005, 0.0, -0.001]
    arm = tube(np.array([rim, middle, at]), 0.0006, Y, 6)
    meshes = [pad, arm]
    if plan.shield:
        meshes += [mirrored(mesh, axis=0) for mesh in meshes]
    return meshes


def _end_piece(plan: FrontPlan, hinge: Float64[np.ndarray, " 3"]) -> Mesh:
    near = plan.outline[np.abs(plan.outline[:, 1] - plan.hinge_height) < 0.006]
    start = float(near[:, 0].max() if len(near) else plan.outer) - 0.5 * plan.rim_width - 0.0015
    path = np.array([[start, hinge[1], 0.0], [hinge[0], hinge[1], 0.0], hinge])
    curve = rounded_polyline(path, 0.006, steps=5)
    thick = max(plan.joint_width, 0.8 * plan.rim_depth if plan.rim == "broad" else 0.0)
    return sweep(curve, superellipse(10, 4.0, (thick / 2, plan.joint_height / 2)), Y)


def _barrel(rng: np.random.Generator, plan: FrontPlan, hinge: Float64[np.ndarray, " 3"]) -> Mesh:
    radius, tall = between(rng, 0.0008, 0.0018), plan.joint_height * between(rng, 0.5, 0.95)
    outline = np.array([[0, -tall / 2], [radius, -tall / 2], [radius, tall / 2], [0, tall / 2]])
    return revolve(outline, segments=8).moved(translation=hinge - [0.5 * plan.joint_width, 0, 0])
